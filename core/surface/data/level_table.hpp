// SPDX-License-Identifier: Apache-2.0
// Level of the colour field on the surface of a body: 3/8 on a plane, less on balls, and much less on small
// drops.
#pragma once
#include <algorithm>
#include <array>

namespace thaw {

/// Level of the iso-surface for a colour field smoothed twice: a = sum V c_j W with the particles' colour
/// c_j = sum V W. The kernel is W = (1 - (r/h_ps)^2)^3. At h_ps = 2 h, the normals of a ball are accurate to
/// 2 degrees, compared to 4 degrees with c (benchmarks/surface). The iso-surface of a fixed level would lie
/// inside curved surfaces, by 0.1 h^2/R on a ball. On drops smaller than the kernel, it would not exist
/// (docs/theory/surfaces.md). The level therefore depends on the fullness b / a with b = sum V a_j W. It is
/// tabulated for continuous balls and cavities of all sizes. For other bodies, it is exact to first order in
/// the mean curvature. It depends on position only, without feedback from the surfels' curvature.
class LevelTable {
 public:
  void fill();
  bool filled() const { return level_[entries] > 0; }
  /// Returns a on the surface as a function of b / a, linear between 512 entries.
  double level(double fullness) const { return at(level_, fullness); }
  /// Returns the derivative of the level.
  double slope(double fullness) const {
    const double s = std::clamp(fullness, 0.0, 1.0) * entries;
    const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(s), entries - 1);
    return entries * (level_[k + 1] - level_[k]);
  }
  /// Returns the distance from the surface, in h_ps, of the particles' mean with weights V c_j W.
  double depth(double fullness) const { return at(depth_, fullness); }

 private:
  static constexpr int entries = 512;
  std::array<double, entries + 1> level_{}, depth_{};
  static double at(const std::array<double, entries + 1>& table, double x);
};

/// Raises the level where few particles are near. Fullness does not distinguish a thin body from a sparse
/// one. A fluid is sparse, for example, if it stretches without cohesive pressure below a spout or in a
/// splash. The surface of such a fluid would enclose up to twice the particles' volume. The density measure
/// is the sum of (1 - (r/nearSupport)^2)^3 over particles, with lengths in spacings. It is 2.6 at half a
/// spacing above a lattice plane, and 0.7 for a single particle. For a row of particles one spacing apart, it
/// is 1.4. Levels in these cases are unchanged. The strength depends on the component (levelRiseOf). Volume
/// enforcement draws in a sparse liquid, as in a splash without surface tension, and least where the liquid
/// is dense. A uniform offset would move the sides of thin rims through each other.
inline constexpr double nearSupport = 2;
struct LevelRise {
  /// densityMeasure: sum below which the level rises; largestRise: relative rise without particles nearby
  double densityMeasure = 0.5, largestRise = 0.6;
};
inline double raisedLevel(double level, double near, const LevelRise& t) {
  return level * (1 + t.largestRise * std::max(0.0, 1 - near / t.densityMeasure));
}

/// Converts the request of volume enforcement (SurfaceComponent::isoOffset in particle spacings, negative
/// inward) to level changes. Inward offsets are limited to leastOffset, and the remainder raises the level in
/// sparse regions. For lattices stretched along two or three axes, this removes about the same volume as the
/// offset.
inline constexpr double leastOffset = -0.35;
inline LevelRise levelRiseOf(double isoOffset) {
  const double more = std::max(leastOffset - isoOffset, 0.0);
  return {0.5 + 3 * more, 0.6 + more};
}
inline double limitedIsoOffset(double isoOffset) { return std::max(isoOffset, leastOffset); }

}  // namespace thaw
