// SPDX-License-Identifier: Apache-2.0
// Prescribed motion of obstacles and constraints.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

struct Keyframe {
  double time = 0;
  Vec3d move{};
  Vec3d rotate{};
};  // s, m, rad; linear between keyframes

}  // namespace thaw
