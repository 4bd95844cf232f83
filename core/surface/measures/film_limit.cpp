// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/film_limit.hpp"

#include <limits>

#include "core/surface/search/near_sheets.hpp"

namespace thaw {
namespace {

/// Search limits for the opposite side, in spacings of surfels: depth behind the surfel, depth past it, and
/// lateral distance.
constexpr double deepest = 1.5, past = 0.2, beside = 0.8;

}  // namespace

double filmOffsetLimit(const Surfels& f, const Bins& bins, std::size_t i, double spacing, double slack) {
  const double reach = spacing * std::hypot(deepest, beside) + slack, most = deepest * spacing,
               widest2 = beside * beside * spacing * spacing;
  double least = std::numeric_limits<double>::infinity();
  const Vec3d x = f.position[i], n = f.normal[i];
  forRowsWithin(bins, x, reach, [&](std::uint32_t j, double) {
    if (dot(n, f.normal[j]) >= twoSheets || f.component[j] != f.component[i]) return;
    const Vec3d d = f.position[j] - x;
    const double depth = -dot(d, n);
    if (depth > most || depth < -past * spacing || dot(d, d) - depth * depth > widest2) return;
    least = std::min(least, depth);
  });
  return 0.5 * (least - thinnestFilm * spacing);
}

}  // namespace thaw
