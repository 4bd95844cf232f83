// SPDX-License-Identifier: Apache-2.0
#include "core/scene/position_field.hpp"

#include <cmath>
#include <cstdio>

namespace thaw {

std::string badValue(const PositionField& f, double value, const Vec3d& x) {
  char at[120];
  std::snprintf(at, sizeof at, "\" is %.6g at (%.6g, %.6g, %.6g)", std::isnan(value) ? NAN : value, x.x, x.y,
                x.z);
  return f.key + ": \"" + f.text + at;
}

Vec3d velocityOf(const VelocityField& f, const Vec3d& centre, const Vec3d& x) {
  Vec3d v{};
  for (int a = 0; a < 3; a++)
    if (f.component[a]) v[a] = f.component[a].value(x);
  return f.linear ? v + f.gradient * (x - centre) : v;
}

}  // namespace thaw
