// Pressure of a particle, for whoever asks: it follows from other fields, and has none of its own.
#pragma once
#include "core/fluid/liquid_materials.hpp"
#include "core/fluid/state_equation.hpp"
#include "core/world.hpp"

namespace thaw {

inline double liquidFraction(const Continuum& p, std::size_t i) {
  return p.liquid.active ? static_cast<double>(p.liquid[i]) : p.phase[i] == Liquid ? 1 : 0;
}

/// Pa, of the last evaluation: what the equation of state makes of the filling, times the liquid fraction;
/// incompressible, what the solver found.
inline float pressureOfParticle(const World& w, const std::vector<LiquidMaterial>& liquids, std::size_t i) {
  const Continuum& p = w.particles;
  if (w.modules.incompressible) return p.holding[i] + p.steadying[i];
  const double f = liquidFraction(p, i), filling = p.filling.active ? static_cast<double>(p.filling[i]) : 0;
  if (f == 0 || filling <= 0) return 0;
  return static_cast<float>(f * pressureOf(w.scene.numerics.eos, liquids[p.material[i]].stiffness, filling,
                                           w.scene.numerics.tensileLimit));
}

}  // namespace thaw
