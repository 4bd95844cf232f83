// SPDX-License-Identifier: Apache-2.0
// Form of surface tension in a scene, and contact angles of its liquids at walls.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "core/scene/modules.hpp"

namespace thaw {

/// Returns true if surface tension is a force from the curvature of the free surface (core/flow/curvature/).
/// This form has no stored energy and no pair sums.
inline bool actsByCurvature(const Numerics& numerics, const Modules& modules) {
  return modules.tension && numerics.tension == TensionForm::Curvature;
}

/// Returns the cosine of a contact angle (rad). It is exactly 0 for 90 degrees, which needs no module.
inline double wettingOf(double angle) {
  const double wetting = std::cos(angle);
  return std::abs(wetting) < 1e-12 ? 0 : wetting;
}

/// Returns one text for each contact angle of a liquid that is not 90 degrees.
std::vector<std::string> contactAnglesOf(const Scene& scene, const Material& liquid);

}  // namespace thaw
