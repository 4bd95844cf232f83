#include "core/geometry/shape_volume.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

double shapeVolume(const SignedDistance& shape, Reducer& all) {
  constexpr int n = 96;
  const Bounds b = shape.bounds();
  const Vec3d cell = (b.max - b.min) * (1.0 / n);
  if (!std::isfinite(cell.x * cell.y * cell.z)) return 0;
  std::int64_t inside = 0;
  const bool gaps = shape.hasGaps();
  for (int row = all.rank(); row < n * n; row += all.size()) {
    const double y = b.min.y + (row % n + 0.5) * cell.y, z = b.min.z + (row / n + 0.5) * cell.z;
    for (int i = 0; i < n;) {  // where the surface is farther away than the next points, they are as this one
      const Vec3d x{b.min.x + (i + 0.5) * cell.x, y, z};
      const double d = gaps ? 0 : shape.distanceWithin(x, 8 * cell.x);
      const int same = std::min(n - i, 1 + static_cast<int>(std::min(std::abs(d) / cell.x * (1 - 1e-9), 1e6)));
      if (gaps ? shape.inside(x) : d < 0) inside += same;
      i += same;
    }
  }
  all.sum({&inside, 1});
  return static_cast<double>(inside) * cell.x * cell.y * cell.z;
}

}  // namespace thaw
