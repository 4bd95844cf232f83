// SPDX-License-Identifier: Apache-2.0
// Sparse grid of cube corners: blocks of 8 x 8 x 8, of which only those near the surface are stored.
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

  /// Makes corners 0 .. count - 1 along each axis, `spacing` (m) apart. Along `cut` axes the first and last
  /// corner lie beyond the cut planes, where the body ends but not its surface. They are outside and have no
  /// values.
  BandGrid(const Vec3d& origin, const Vec3d& spacing, const Corner& count,
           const std::array<bool, 3>& cut = {});

  Vec3d place(const Corner& c) const {
    return origin_ + Vec3d{spacing_.x * static_cast<double>(c[0]), spacing_.y * static_cast<double>(c[1]),
                           spacing_.z * static_cast<double>(c[2])};
  }
  double spacing() const { return std::max({spacing_.x, spacing_.y, spacing_.z}); }
  const Corner& count() const { return count_; }
  bool cut(int axis) const { return first_[static_cast<std::size_t>(axis)] > 0; }
  /// Returns the axes, as bits, along which a corner lies beyond a cut. onCut: on a cut plane.
  int beyond(const Corner& c) const {
    return bits([&](std::size_t a) { return c[a] < first_[a] || c[a] > last_[a]; });
  }
  int onCut(const Corner& c) const {
    return bits([&](std::size_t a) { return first_[a] > 0 && (c[a] == first_[a] || c[a] == last_[a]); });
  }
  std::uint64_t key(const Corner& c) const {
    return static_cast<std::uint64_t>(c[0] + count_[0] * (c[1] + count_[1] * c[2]));
  }

  /// Calls f(corner, its vector from x) for corners within `reach` (m) of a position, in the grid and not
  /// beyond a cut.
  template<class F> void forCornersNear(const Vec3d& x, double reach, F f) const;

  /// Returns the slot of a corner, and creates it if needed: slots count from 0 in order of creation.
  std::int32_t makeSlot(const Corner& c);
  /// Returns the slot, or outside, inside, open (a corner without slot before classify).
  std::int32_t at(const Corner& c) const;
  /// Returns the slot of a corner that has one.
  std::int32_t slotOf(const Corner& c) const {
    return kept_[static_cast<std::size_t>(table_[static_cast<std::size_t>(blockOf(c))])].slot[within(c)];
  }
  std::size_t slots() const { return corners_.size(); }
  const Corner& corner(std::size_t slot) const { return corners_[slot]; }

  /// Classifies corners without a slot by connected region: each is inside if most adjacent slots are
  /// (isInside, one per slot). Regions that reach a border without a cut are outside.
  void classify(const std::vector<std::uint8_t>& isInside);

 private:
  struct Region;
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
  std::vector<std::int32_t> table_;  // per block: index of a stored block, or outside, inside, open for all
                                     // its corners
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
        if (dot(d, d) < reach * reach) f(Corner{i, j, k}, d);
      }
}

}  // namespace thaw
