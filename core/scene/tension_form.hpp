// SPDX-License-Identifier: Apache-2.0
// Which form of surface tension acts in a scene.
#pragma once
#include "core/scene/modules.hpp"

namespace thaw {

/// Returns true if surface tension is a force by the curvature of the free surface (core/flow/curvature/).
/// It has no stored energy and no pair sums.
inline bool actsByCurvature(const Numerics& numerics, const Modules& modules) {
  return modules.tension && numerics.tension == TensionForm::Curvature;
}

}  // namespace thaw
