// Rows of a table in bins of any edge, owned and ghost rows alike: for questions whose answer does not depend on the order in which rows are
// met (nearest, which are joined), or that sort what they find.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

class PointBins {
 public:
  /// Bins of this edge (m) for n points. The points must stay where they are while it is used.
  void build(const Vec3d* at, std::size_t n, double edge);

  /// f(row, square of the distance) for all rows within `radius` (m) of x, that of x itself included.
  template<class F> void forEachWithin(const Vec3d& x, double radius, F&& f) const {
    if (row_.empty()) return;
    const Vec3i low = bin(x, -radius), high = bin(x, radius);
    const double r2 = radius * radius;
    for (int z = low.z; z <= high.z; z++)
      for (int y = low.y; y <= high.y; y++) {
        // bins that follow each other along x follow each other here
        const std::uint64_t last = key({high.x, y, z});
        auto b = static_cast<std::size_t>(std::lower_bound(key_.begin(), key_.end(), key({low.x, y, z})) - key_.begin());
        for (; b < key_.size() && key_[b] <= last; b++)
          for (std::uint32_t k = first_[b]; k < first_[b + 1]; k++) {
            const Vec3d d = at_[row_[k]] - x;
            const double d2 = dot(d, d);
            if (d2 <= r2) f(row_[k], d2);
          }
      }
  }

 private:
  Vec3i bin(const Vec3d& x, double shift) const {
    Vec3i b;
    for (int a = 0; a < 3; a++) b[a] = static_cast<int>(std::clamp(std::floor((x[a] + shift - low_[a]) / edge_), 0.0, 2097150.0));
    return b;
  }
  static std::uint64_t key(const Vec3i& b) {
    return static_cast<std::uint64_t>(b.z) << 42 | static_cast<std::uint64_t>(b.y) << 21 | static_cast<std::uint64_t>(b.x);
  }

  const Vec3d* at_ = nullptr;
  Vec3d low_{};
  double edge_ = 1;
  std::vector<std::uint64_t> key_;         // of bins with points, ascending
  std::vector<std::uint32_t> first_, row_; // rows of bin b: row_[first_[b]] ... row_[first_[b + 1] - 1], ascending
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_;
};

}  // namespace thaw
