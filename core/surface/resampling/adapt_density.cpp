// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/adapt_density.hpp"

#include <algorithm>
#include <cmath>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/search/local_surface.hpp"

namespace thaw {
namespace {

/// Calls f(j, distance) for the neighbours of i on the same side of the film.
template<class F> void forNeighbours(const Surfels& s, const RowLists& lists, std::size_t i, F&& f) {
  for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
    const std::uint32_t j = lists.row[k];
    if (s.component[j] == s.component[i] && dot(s.normal[j], s.normal[i]) > oneSide)
      f(j, length(s.position[j] - s.position[i]));
  }
}

}  // namespace

void adaptDensity(Surface& surface, CellHalo& halo, const RowLists& lists, double reach, double finest) {
  Surfels& s = surface.surfels;
  const double d = surface.spacing;
  ColumnList sent{&s.targetRadius};
  std::vector<double> next(s.owned);
  Patch patch;
  for (std::size_t i = 0; i < s.owned; i++) {
    s.targetRadius[i] = d;
    if (!(finest < d)) continue;
    patch.gather(s, i, lists, std::min(2.5 * s.radius[i], reach));
    patch.fitCurvature();
    s.targetRadius[i] = std::clamp(angleBetween / std::max(patch.largestCurvature(), 1e-12 / d), finest, d);
  }
  if (finest < d) {
    refreshGhosts(halo, s, sent);
    // The mean of 1/r is the mean of curvatures.
    for (std::size_t i = 0; i < s.owned; i++) {
      double sum = 1 / s.targetRadius[i], weight = 1;
      forNeighbours(s, lists, i, [&](std::uint32_t j, double away) {
        if (away < 1.5 * s.radius[i]) sum += 1 / s.targetRadius[j], weight += 1;
      });
      next[i] = weight / sum;
    }
    for (int pass = 0; pass < 2; pass++) {
      std::copy(next.begin(), next.end(), s.targetRadius.data());
      refreshGhosts(halo, s, sent);
      for (std::size_t i = 0; i < s.owned; i++)
        forNeighbours(s, lists, i, [&](std::uint32_t j, double away) {
          next[i] = std::min(next[i], s.targetRadius[j] + grading * away);
        });
    }
    std::copy(next.begin(), next.end(), s.targetRadius.data());
  }
  for (std::size_t i = 0; i < s.owned; i++) {
    const double off = s.targetRadius[i] - s.radius[i];
    if (!(std::abs(off) > 0.1 * s.radius[i])) continue;
    s.radius[i] += 0.5 * off;
    s.resampleMargin[i] = 0;
  }
  ColumnList radius{&s.radius, &s.resampleMargin};
  refreshGhosts(halo, s, radius);
}

}  // namespace thaw
