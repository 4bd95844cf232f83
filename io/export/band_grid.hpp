// Corners of cubes near a surface, in blocks of 8 x 8 x 8 of which only those near the surface are kept.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

class BandGrid {
 public:
  static constexpr std::int64_t side = 8;  ///< corners of a block along an axis
  static constexpr std::int32_t outside = -1, inside = -2, open = -3;
  using Corner = std::array<std::int64_t, 3>;

  /// Corners 0 .. count - 1 along each axis.
  BandGrid(const Vec3d& origin, double spacing, const Corner& count);

  Vec3d place(const Corner& c) const {
    return origin_ + spacing_ * Vec3d{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  }
  double spacing() const { return spacing_; }
  const Corner& count() const { return count_; }
  std::uint64_t key(const Corner& c) const { return static_cast<std::uint64_t>(c[0] + count_[0] * (c[1] + count_[1] * c[2])); }

  /// Corners nearer than `reach` (m) to a place, within the grid: f(corner).
  template<class F> void forCornersNear(const Vec3d& x, double reach, F f) const;

  /// The slot of a corner, made if it has none: slots count from 0 in the order in which they were made.
  std::int32_t makeSlot(const Corner& c);
  /// The slot, or outside, inside, open (of corners without one; settled by settle).
  std::int32_t at(const Corner& c) const;
  std::size_t slots() const { return corners_.size(); }
  const Corner& corner(std::size_t slot) const { return corners_[slot]; }

  /// Decides which corners without a slot are inside: each connected set of them by what most of the slots beside it are (isInside, one a
  /// slot); those that reach the border are outside.
  void settle(const std::vector<std::uint8_t>& isInside);

 private:
  struct Block { std::array<std::int32_t, side * side * side> slot; };
  std::int64_t blockOf(const Corner& c) const { return c[0] / side + blocks_[0] * (c[1] / side + blocks_[1] * (c[2] / side)); }
  static std::size_t within(const Corner& c) { return static_cast<std::size_t>(c[0] % side + side * (c[1] % side + side * (c[2] % side))); }
  std::int32_t& entry(const Corner& c);

  Vec3d origin_;
  double spacing_;
  Corner count_, blocks_;
  std::vector<std::int32_t> table_;  // of all blocks: one that is kept, or outside, inside, open for all its corners
  std::vector<Block> kept_;
  std::vector<Corner> corners_;
};

template<class F> void BandGrid::forCornersNear(const Vec3d& x, double reach, F f) const {
  const Vec3d at = (x - origin_) / spacing_;
  const double r = reach / spacing_;
  Corner low, high;
  for (int a = 0; a < 3; a++) {
    low[a] = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(at[a] - r)));
    high[a] = std::min<std::int64_t>(count_[a] - 1, static_cast<std::int64_t>(std::floor(at[a] + r)));
  }
  for (std::int64_t k = low[2]; k <= high[2]; k++)
    for (std::int64_t j = low[1]; j <= high[1]; j++)
      for (std::int64_t i = low[0]; i <= high[0]; i++) {
        const Vec3d d = Vec3d{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)} - at;
        if (dot(d, d) < r * r) f(Corner{i, j, k});
      }
}

}  // namespace thaw
