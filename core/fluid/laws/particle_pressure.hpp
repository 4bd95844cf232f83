// SPDX-License-Identifier: Apache-2.0
// Pressure of a particle, computed from other fields.
#pragma once
#include <cstddef>
#include <vector>

#include "core/materials/liquid_materials.hpp"
#include "core/materials/state_equation.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

inline double liquidFraction(const Continuum& p, std::size_t i) {
  return p.liquid.active ? static_cast<double>(p.liquid[i]) : p.phase[i] == Liquid ? 1 : 0;
}

/// Strength of pairwise cohesion of a particle, (N/m)^1/2.
inline double rootTensionOf(const Continuum& p, const std::vector<LiquidMaterial>& liquids, std::size_t i) {
  return liquids[p.material[i]].rootTension * liquidFraction(p, i);
}

/// Pressure (Pa) of the last evaluation: the equation of state times the liquid fraction, or the solution of
/// the incompressible solver.
inline float pressureOfParticle(const Scene& scene, const Modules& modules, const Continuum& p,
                                const std::vector<LiquidMaterial>& liquids, std::size_t i) {
  if (modules.incompressible) return p.densityPressure[i] + p.divergencePressure[i];
  const double f = liquidFraction(p, i),
               relativeDensity = p.relativeDensity.active ? static_cast<double>(p.relativeDensity[i]) : 0;
  if (f == 0 || relativeDensity <= 0) return 0;
  return static_cast<float>(f * pressureOf(scene.numerics.eos, liquids[p.material[i]].stiffness,
                                           relativeDensity, scene.numerics.tensileLimit));
}

}  // namespace thaw
