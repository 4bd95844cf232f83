// SPDX-License-Identifier: Apache-2.0
// Viscosity of a solid in pairs with liquid.
#pragma once
#include <algorithm>

namespace thaw {

/// Returns the viscosity (Pa s) with which a particle of the liquid fraction f enters harmonic means. A solid
/// does not shear, so its viscosity is practically infinite. The mean is then twice the liquid's viscosity:
/// the liquid sticks to the surface half-way between the particles. In a melting particle the front is
/// deeper, on average in the middle, where the mean with the particle's own viscosity applies. The factor
/// thus falls to 1 at a liquid fraction of 0.05.
inline double stickingViscosity(double viscosity, double f) {
  constexpr double solid = 1e15, molten = 0.05;
  if (f >= molten) return viscosity;
  const double sticks = 1 - f / molten;
  return sticks < 1 ? std::min(solid, viscosity * (1 + sticks) / (1 - sticks)) : solid;
}

}  // namespace thaw
