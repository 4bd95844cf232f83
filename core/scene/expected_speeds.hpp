// SPDX-License-Identifier: Apache-2.0
// Speeds to expect in a scene. Contact stiffness and the automatic sound speed follow from them.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Fastest translation between two keyframes (m/s); 0 without keyframes. Rotation is ignored.
inline double fastestMove(const std::vector<Keyframe>& motion) {
  double fastest = 0;
  for (std::size_t k = 1; k < motion.size(); k++)
    if (const double over = motion[k].time - motion[k - 1].time; over > 0)
      fastest = std::max(fastest, length(motion[k].move - motion[k - 1].move) / over);
  return fastest;
}

/// An expected speed (m/s) and its cause.
struct FlowSpeed {
  double speed = 0;
  std::string why;
};

/// Returns the speed from which the automatic sound speed is derived. A flow of speed v changes the density
/// by v^2 / c^2, a column of height H by g H / c^2 (M94). v^2 = u^2 + 2 g h. u is the largest speed of
/// bodies, emitters and obstacles, h the largest fall. A column of bodies is no higher than the fall, so v
/// covers it. A column that an emitter fills may be higher. Buoyancy adds the square of its speed.
FlowSpeed expectedFlow(const Scene& scene);

/// Speed of a fall from rest through the whole domain (m/s).
inline double fallSpeed(const Domain& d) {
  double height = 0;  // height times gravity
  for (int a = 0; a < 3; a++) height += std::abs(d.gravity[a]) * (d.max[a] - d.min[a]);
  return std::sqrt(2 * height);
}

}  // namespace thaw
