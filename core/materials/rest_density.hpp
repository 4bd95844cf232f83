// SPDX-License-Identifier: Apache-2.0
// Density at rest of a particle. The mass of a particle is constant; its volume at rest is mass over this
// density.
#pragma once
#include <vector>

#include "core/particles/continuum.hpp"
#include "core/scene/phase_density.hpp"

namespace thaw {

/// Density at rest (kg/m^3) of a particle with this phase and liquid fraction. A solid keeps its density
/// until its phase changes, so bonds and rigid pieces keep their lengths. Solid and liquid parts of a liquid
/// particle add their volumes: 1/rho = (1-f)/rho_s + f/rho_l. Here f is measured from the liquid fraction at
/// which the particle freezes (hysteresis). A particle that freezes thus has the density of the solid.
inline double targetRestDensity(const Material& m, Phase phase, double liquidFraction) {
  if (phase == Solid) return solidDensityOf(m);
  if (!hasPhaseDensities(m)) return m.density;
  const double f = std::clamp((liquidFraction - m.hysteresis) / (1 - m.hysteresis), 0.0, 1.0);
  return f == 1 ? m.density : 1 / ((1 - f) / m.solidDensity + f / m.density);
}

/// Density at rest (kg/m^3) of a particle.
inline double restDensityOf(const Continuum& p, const std::vector<Material>& materials, std::size_t i) {
  return p.restDensity.active ? p.restDensity[i] : materials[p.material[i]].density;
}

/// Volume at rest (m^3) of a particle.
inline double restVolumeOf(const Continuum& p, const std::vector<Material>& materials, std::size_t i) {
  return p.mass[i] / restDensityOf(p, materials, i);
}

}  // namespace thaw
