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
  /// Points of some bins, one behind another.
  struct Block {
    std::vector<Vec3d> at;
    std::vector<std::uint32_t> row;
  };

  /// Bins of this edge (m) for n points.
  void build(const Vec3d* at, std::size_t n, double edge);

  /// f(row, square of the distance) for all rows within `radius` (m) of x, that of x itself included.
  template<class F> void forEachWithin(const Vec3d& x, double radius, F&& f) const {
    const double r2 = radius * radius;
    const Vec3d r{radius, radius, radius};
    forEachRun(x - r, x + r, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; k++) {
        const Vec3d d = at_[k] - x;
        const double d2 = dot(d, d);
        if (d2 <= r2) f(row_[k], d2);
      }
    });
  }

  /// f(row, block) for every row, with a block that holds at least all rows of `other` within `radius` (m) of it: one look-up for each bin of
  /// points, which wants bins of about that edge. `other` may be these bins.
  template<class F> void forEachBlock(const PointBins& other, double radius, Block& block, F&& f) const {
    for (std::size_t b = 0; b < key_.size(); b++) {
      Vec3d low = at_[first_[b]], high = low;
      for (std::uint32_t k = first_[b] + 1; k < first_[b + 1]; k++)
        for (int a = 0; a < 3; a++) {
          low[a] = std::min(low[a], at_[k][a]);
          high[a] = std::max(high[a], at_[k][a]);
        }
      const Vec3d r{radius, radius, radius};
      block.at.clear();
      block.row.clear();
      other.forEachRun(low - r, high + r, [&](std::size_t begin, std::size_t end) {
        block.at.insert(block.at.end(), other.at_.begin() + static_cast<std::ptrdiff_t>(begin), other.at_.begin() + static_cast<std::ptrdiff_t>(end));
        block.row.insert(block.row.end(), other.row_.begin() + static_cast<std::ptrdiff_t>(begin), other.row_.begin() + static_cast<std::ptrdiff_t>(end));
      });
      for (std::uint32_t k = first_[b]; k < first_[b + 1]; k++) f(row_[k], block);
    }
  }

 private:
  /// f(begin, end) of places in the order of bins that hold what lies in the box.
  template<class F> void forEachRun(const Vec3d& boxLow, const Vec3d& boxHigh, F&& f) const {
    if (row_.empty()) return;
    const Vec3i low = bin(boxLow), high = bin(boxHigh);
    for (int z = low.z; z <= high.z; z++)
      for (int y = low.y; y <= high.y; y++) {
        // bins that follow each other along x follow each other here
        const auto from = std::lower_bound(key_.begin(), key_.end(), key({low.x, y, z}));
        auto to = from;
        for (const std::uint64_t last = key({high.x, y, z}); to != key_.end() && *to <= last;) ++to;
        if (from != to) f(first_[static_cast<std::size_t>(from - key_.begin())], first_[static_cast<std::size_t>(to - key_.begin())]);
      }
  }
  Vec3i bin(const Vec3d& x) const {
    Vec3i b;
    for (int a = 0; a < 3; a++) b[a] = static_cast<int>(std::clamp(std::floor((x[a] - low_[a]) / edge_), 0.0, 2097150.0));
    return b;
  }
  static std::uint64_t key(const Vec3i& b) {
    return static_cast<std::uint64_t>(b.z) << 42 | static_cast<std::uint64_t>(b.y) << 21 | static_cast<std::uint64_t>(b.x);
  }

  Vec3d low_{};
  double edge_ = 1;
  std::vector<std::uint64_t> key_;            // of bins with points, ascending
  std::vector<std::uint32_t> first_, row_;    // rows of bin b: row_[first_[b]] ... row_[first_[b + 1] - 1], ascending
  std::vector<Vec3d> at_;                     // beside row_
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_;
};

}  // namespace thaw
