// SPDX-License-Identifier: Apache-2.0
// Expected speeds in a scene. Contact stiffness and the automatic sound speed follow from these speeds.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the largest speed of translation between two keyframes (m/s); 0 without keyframes. Rotation is
/// ignored.
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

/// Returns the speed from which the automatic sound speed is derived. At sound speed c, a flow of speed v
/// changes the relative density by v^2 / c^2. A column of height H changes it by g H / c^2 (M94). Here v^2 =
/// u^2 + 2 g h. u is the largest speed of bodies, emitters and obstacles, and h is the largest height of
/// fall. A column of bodies is not higher than h, so v covers it. A column filled by an emitter may be
/// higher. Buoyancy adds the square of buoyantSpeed.
FlowSpeed expectedFlow(const Scene& scene);

/// Returns the speed (m/s) after a fall from rest through the whole domain.
inline double fallSpeed(const Domain& d) {
  double height = 0;  // height times gravity
  for (int a = 0; a < 3; a++) height += std::abs(d.gravity[a]) * (d.max[a] - d.min[a]);
  return std::sqrt(2 * height);
}

}  // namespace thaw
