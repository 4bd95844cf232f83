// Speeds that a scene leads to, from what it says: what contacts and sound speeds are made for.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// m/s, the fastest shift between two keyframes; 0 without any. Turning is left out.
inline double fastestMove(const std::vector<Keyframe>& motion) {
  double fastest = 0;
  for (std::size_t k = 1; k < motion.size(); k++)
    if (const double over = motion[k].time - motion[k - 1].time; over > 0) fastest = std::max(fastest, length(motion[k].move - motion[k - 1].move) / over);
  return fastest;
}

/// m/s, of a fall from rest through the whole domain.
inline double fallSpeed(const Domain& d) {
  double height = 0;  // times gravity
  for (int a = 0; a < 3; a++) height += std::abs(d.gravity[a]) * (d.max[a] - d.min[a]);
  return std::sqrt(2 * height);
}

}  // namespace thaw
