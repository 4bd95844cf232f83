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

  /// Corners 0 .. count - 1 along each axis, `spacing` (m) apart. Along axes that are `cut` the first and the
  /// last one are beyond a plane through the next ones where the body ends, though its surface does not: they
  /// are outside, and nothing is known of them.
  BandGrid(const Vec3d& origin, const Vec3d& spacing, const Corner& count,
           const std::array<bool, 3>& cut = {});

  Vec3d place(const Corner& c) const {
    return origin_ + Vec3d{spacing_.x * static_cast<double>(c[0]), spacing_.y * static_cast<double>(c[1]),
                           spacing_.z * static_cast<double>(c[2])};
  }
  double spacing() const { return std::max({spacing_.x, spacing_.y, spacing_.z}); }
  const Corner& count() const { return count_; }
  bool cut(int axis) const { return first_[static_cast<std::size_t>(axis)] > 0; }
  /// The axes along which a corner is beyond a cut, or on one, as bits.
  int beyond(const Corner& c) const {
    return bits([&](std::size_t a) { return c[a] < first_[a] || c[a] > last_[a]; });
  }
  int onCut(const Corner& c) const {
    return bits([&](std::size_t a) { return first_[a] > 0 && (c[a] == first_[a] || c[a] == last_[a]); });
  }
  std::uint64_t key(const Corner& c) const {
    return static_cast<std::uint64_t>(c[0] + count_[0] * (c[1] + count_[1] * c[2]));
  }

  /// Corners nearer than `reach` (m) to a place, within the grid and not beyond a cut: f(corner).
  template<class F> void forCornersNear(const Vec3d& x, double reach, F f) const;

  /// The slot of a corner, made if it has none: slots count from 0 in the order in which they were made.
  std::int32_t makeSlot(const Corner& c);
  /// The slot, or outside, inside, open (of corners without one; settled by settle).
  std::int32_t at(const Corner& c) const;
  std::size_t slots() const { return corners_.size(); }
  const Corner& corner(std::size_t slot) const { return corners_[slot]; }

  /// Decides which corners without a slot are inside: each connected set of them by what most of the slots
  /// beside it are (isInside, one a slot); those that reach the border, where it is no cut, are outside.
  void settle(const std::vector<std::uint8_t>& isInside);

 private:
  struct Block {
    std::array<std::int32_t, side * side * side> slot;
  };
  template<class Is> static int bits(Is is) { return (is(0) ? 1 : 0) | (is(1) ? 2 : 0) | (is(2) ? 4 : 0); }
  std::int64_t blockOf(const Corner& c) const {
    return c[0] / side + blocks_[0] * (c[1] / side + blocks_[1] * (c[2] / side));
  }
  static std::size_t within(const Corner& c) {
    return static_cast<std::size_t>(c[0] % side + side * (c[1] % side + side * (c[2] % side)));
  }
  std::int32_t& entry(const Corner& c);

  Vec3d origin_, spacing_;
  Corner count_, blocks_, first_, last_;  // corners first_ to last_ are not beyond a cut
  std::vector<std::int32_t> table_;  // of all blocks: one that is kept, or outside, inside, open for all its
                                     // corners
  std::vector<Block> kept_;
  std::vector<Corner> corners_;
};

template<class F> void BandGrid::forCornersNear(const Vec3d& x, double reach, F f) const {
  Corner low, high;
  for (int a = 0; a < 3; a++) {
    const std::size_t k = static_cast<std::size_t>(a);
    const double at = (x[a] - origin_[a]) / spacing_[a], r = reach / spacing_[a];
    low[k] = std::max(first_[k], static_cast<std::int64_t>(std::ceil(at - r)));
    high[k] = std::min(last_[k], static_cast<std::int64_t>(std::floor(at + r)));
  }
  for (std::int64_t k = low[2]; k <= high[2]; k++)
    for (std::int64_t j = low[1]; j <= high[1]; j++)
      for (std::int64_t i = low[0]; i <= high[0]; i++) {
        const Vec3d d = place({i, j, k}) - x;
        if (dot(d, d) < reach * reach) f(Corner{i, j, k});
      }
}

}  // namespace thaw
