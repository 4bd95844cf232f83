// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/free_surface.hpp"

namespace thaw {

Vec3d alongWalls(Vec3d v, std::span<const WallContact> contacts, double spacing) {
  // distance in spacings within which a wall is adjacent
  constexpr double wallLayer = 1.2;
  for (const WallContact& c : contacts)
    if (c.distance < wallLayer * spacing) v -= c.normal * dot(v, c.normal);
  return v;
}

}  // namespace thaw
