#include "core/geometry/signed_distance.hpp"

namespace thaw {

double SignedDistance::extent(const Vec3d& direction) const {
  const Bounds b = bounds();
  double e = 0;
  for (int a = 0; a < 3; a++)
    if (direction[a] != 0) e += direction[a] * (direction[a] > 0 ? b.max[a] : b.min[a]);  // never 0 times infinity
  return e;
}

double SignedDistance::outerExtent(const Vec3d&) const { return never; }

Bounds boundsFromExtents(const SignedDistance& shape) {
  return {{-shape.extent({-1, 0, 0}), -shape.extent({0, -1, 0}), -shape.extent({0, 0, -1})},
          {shape.extent({1, 0, 0}), shape.extent({0, 1, 0}), shape.extent({0, 0, 1})}};
}

}  // namespace thaw
