// SPDX-License-Identifier: Apache-2.0
// Damping of the waves of a few spacings that tension by curvature excites at the free surface.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/materials/liquid_materials.hpp"

namespace thaw {

/// Returns the viscosity (Pa s) of approaching pairs at the free surface: 0.1 rho u h, with the capillary
/// speed of the spacing u = sqrt(gamma / (rho dx)), at most a tenth of the speed of sound. 0 with other forms
/// of tension.
inline double surfaceDamping(const Scene& s, const Material& m, double soundSpeed) {
  if (s.numerics.tension != TensionForm::Curvature || !(m.surfaceTension > 0)) return 0;
  const double speed = std::sqrt(m.surfaceTension / (m.density * s.spacing));
  return 0.1 * m.density * std::min(speed, 0.1 * soundSpeed) * s.numerics.support * s.spacing;
}

}  // namespace thaw
