// SPDX-License-Identifier: Apache-2.0
// Equations of state of the liquid as functions of the relative density delta = rho / rho0.
#pragma once
#include <cmath>

#include "core/scene/scene.hpp"

namespace thaw {

/// Pressure (Pa). Linear: p = c^2 rho0 (delta - 1) (K05 3.2, DC96: k = c^2). Tait: p = rho0 c^2 / 7 (delta^7
/// - 1) (M94). Negative pressure is multiplied by tensileLimit, since the summed density is too low
/// at a free surface (docs/validation/stability.md, rows 6 and 7).
inline double pressureOf(EquationOfState eos, double stiffness, double relativeDensity, double tensileLimit) {
  double p = 0;
  if (eos == EquationOfState::Linear) {
    p = stiffness * (relativeDensity - 1);
  } else {
    const double f2 = relativeDensity * relativeDensity, f4 = f2 * f2;
    p = stiffness / 7 * (f4 * f2 * relativeDensity - 1);
  }
  return p >= 0 ? p : tensileLimit * p;
}

/// Ratio of the sound speed to that at rest, sqrt(dp/ddelta / c^2 rho0), under compression; else 1. The term
/// p / delta of the pairs' stiffness is smaller and is neglected.
inline double soundSpeedFactor(EquationOfState eos, double relativeDensity) {
  return eos == EquationOfState::Tait && relativeDensity > 1
             ? relativeDensity * relativeDensity * relativeDensity
             : 1;
}

/// Compression energy per rest volume (J/m^3): the integral of p / delta^2 over delta from 1.
inline double compressionEnergy(EquationOfState eos, double stiffness, double relativeDensity,
                                double tensileLimit) {
  const double factor = relativeDensity >= 1 ? 1 : tensileLimit;
  if (factor == 0 || relativeDensity <= 0) return 0;
  if (eos == EquationOfState::Linear)
    return factor * stiffness * (std::log(relativeDensity) + 1 / relativeDensity - 1);
  const double f2 = relativeDensity * relativeDensity, f6 = f2 * f2 * f2;
  return factor * stiffness / 7 * ((f6 - 1) / 6 + 1 / relativeDensity - 1);
}

}  // namespace thaw
