// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/enclosed_volume.hpp"

namespace thaw {
namespace {

/// Uncertainty of the heights of rims, in spacings of the surfels.
constexpr double surelyAt = 0.5;

}  // namespace

double enclosedVolume(const FacetSums& s, const Vec3d& middle, const std::array<bool, 3>& round,
                      double spacing) {
  const bool all = round[0] && round[1] && round[2];
  const auto determined = [&](std::size_t a) { return all || !round[a]; };
  const Vec3d from = s.rim > 0 ? s.rimPlace / s.rim : middle;
  const double sure = surelyAt * spacing;
  Mat3d spread = identity3<double>();
  if (s.rim > 0) {
    const Sym3d& q = s.rimSquare;
    const Mat3d square{{{q.xx, q.xy, q.xz}, {q.xy, q.yy, q.yz}, {q.xz, q.yz, q.zz}}};
    spread = spread + (1 / (sure * sure)) * ((1 / s.rim) * square - outer(from, from));
    for (std::size_t a = 0; a < 3; a++)
      for (std::size_t b = 0; b < 3; b++)
        if (a != b && !(determined(a) && determined(b))) spread.row[a][static_cast<int>(b)] = 0;
  }
  const Mat3d weight = inverse(spread);
  double volume = 0, trace = 0;
  for (std::size_t a = 0; a < 3; a++) {
    const int x = static_cast<int>(a), y = (x + 1) % 3, z = (x + 2) % 3;
    // The weights of undetermined axes are 0.
    volume += weight.row[y][z] * (s.mixed[x] - from[y] * s.facets[z] - from[z] * s.facets[y]);
    if (!determined(a)) continue;
    trace += weight.row[a][x];
    volume += weight.row[a][x] * (s.volume[x] - from[x] * s.facets[x]);
  }
  return volume / trace;
}

}  // namespace thaw
