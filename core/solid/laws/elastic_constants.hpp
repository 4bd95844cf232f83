// SPDX-License-Identifier: Apache-2.0
// Elastic constants of a material at a liquid fraction.
#pragma once
#include <cmath>

#include "core/scene/scene.hpp"
#include "core/solid/laws/elastic_law.hpp"

namespace thaw {

struct ElasticConstants {
  double lambda = 0, mu = 0;      ///< Pa, Lame's constants
  double volume = 0;              ///< Pa, k_v of the volume force
  double hourglass = 0;           ///< Pa, alpha E
  double hourglassYield = never;  ///< 1, bond error above which the hourglass stress is constant
  double yield = never;           ///< 1, |dev sigma|/2G at yield
  double creep = 0;               ///< 1/s
  double hardening = 0;           ///< 1, increase of `yield` with the equivalent plastic strain
  double maxPlastic = never;      ///< 1
  double dragDensity = 0;         ///< kg/(m^3 s), damping * density
  const BoundLaw* law = nullptr;  ///< null: no solid
};

/// Returns the constants of a material at this liquid fraction (K05 3.3), with its law, boundLaw(m).
inline ElasticConstants elasticConstants(const Material& m, double liquidFraction, const BoundLaw& law) {
  ElasticConstants c;
  const double young = m.young.at(liquidFraction), nu = m.poisson.at(liquidFraction);
  c.lambda = young * nu / ((1 + nu) * (1 - 2 * nu));
  c.mu = young / (2 * (1 + nu));
  c.volume = m.volumeStiffness;
  c.hourglass = m.hourglass * young;
  // Blending must not turn an infinite value, which means no plasticity, into NaN.
  c.yield = m.yieldStrain.solid < never && m.yieldStrain.liquid < never ? m.yieldStrain.at(liquidFraction)
                                                                        : m.yieldStrain.solid;
  c.creep = m.creepRate.solid < never && m.creepRate.liquid < never ? m.creepRate.at(liquidFraction)
                                                                    : m.creepRate.solid;
  // sigma_eq = sqrt(3/2) 2G yield; the same fraction of G at any liquid fraction
  if (m.hardening > 0) c.hardening = m.hardening * (1 + m.poisson.solid) / (std::sqrt(1.5) * m.young.solid);
  c.maxPlastic = m.maxPlasticStrain;
  // In a material that yields at once, an hourglass stress above the yield stress sqrt(6) G y would resist
  // the flow.
  if (c.yield < never && c.creep == never && c.maxPlastic == never && c.hourglass > 0)
    c.hourglassYield = std::sqrt(6.0) * c.mu * c.yield / c.hourglass;
  c.dragDensity = m.damping * m.density;
  c.law = &law;
  return c;
}
/// The same for a material, whose law is looked up by name. Do not use it in loops over particles.
inline ElasticConstants elasticConstants(const Material& m, double liquidFraction) {
  return elasticConstants(m, liquidFraction, boundLaw(m));
}

/// Returns the energy (Pa) of hourglass control for a mean square error of the bonds. Beyond hourglassYield,
/// the hourglass stress is constant.
inline double hourglassEnergy(const ElasticConstants& c, double squareError) {
  if (!(squareError > c.hourglassYield * c.hourglassYield)) return 0.5 * c.hourglass * squareError;
  return c.hourglass * c.hourglassYield * (std::sqrt(squareError) - 0.5 * c.hourglassYield);
}

}  // namespace thaw
