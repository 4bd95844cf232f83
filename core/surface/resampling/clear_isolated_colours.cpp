// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/clear_isolated_colours.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/surface/data/mean_colour.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/resampling/birth_colours.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

// spacings; contains about fifteen surfels
constexpr double around = 2.2;
// smallest dot product of normals on the same side
constexpr double sameSide = 0.3;
// difference of 255 in one colour channel
constexpr int unlike = 24;
constexpr std::int64_t least = 5;

bool differ(std::uint32_t a, std::uint32_t b) {
  for (int c = 0; c < 3; c++)
    if (std::abs(static_cast<int>(a >> 8 * c & 255) - static_cast<int>(b >> 8 * c & 255)) > unlike)
      return true;
  return false;
}

/// Returns whether at least two colours exist over all ranks.
bool several(const Surfels& f, Reducer& all) {
  double range[2] = {-1, -16777216};  // largest and minus smallest colour
  for (std::size_t i = 0; i < f.owned; i++) {
    range[0] = std::max(range[0], static_cast<double>(f.colour[i]));
    range[1] = std::max(range[1], -static_cast<double>(f.colour[i]));
  }
  all.maximum(range);
  return range[0] > -range[1];
}

/// Returns the colours of all owned surfels. Isolated colours are replaced.
std::vector<std::uint32_t> clearedColours(const Surface& s, const Bins& bins) {
  const Surfels& f = s.surfels;
  std::vector<std::uint32_t> colour(f.colour.data(), f.colour.data() + f.owned);
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!(f.liquid[i] > 0.5f)) continue;
    std::int64_t others = 0, unlikes = 0;
    MeanColour mean;
    forRowsWithin(bins, f.position[i], around * s.spacing, [&](std::uint32_t j, double) {
      if (f.id[j] == f.id[i] || f.component[j] != f.component[i] ||
          !(dot(f.normal[i], f.normal[j]) > sameSide))
        return;
      others++;
      unlikes += differ(f.colour[i], f.colour[j]);
      mean.add(1, f.colour[j]);
    });
    if (others >= least && 5 * unlikes >= 4 * others) colour[i] = mean.colour();
  }
  return colour;
}

}  // namespace

void clearIsolatedColours(const Scene& scene, Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  Surfels& f = s.surfels;
  if (!f.liquid.active || !coloursMayDiffer(scene) || !several(f, halos.all)) return;
  placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
  addGhosts(halos.surfels, f, s.surfelCells,
            ColumnList{&f.id, &f.position, &f.normal, &f.component, &f.colour});
  fillBins(s.grid, s.surfelCells, f.position.data(), around * s.spacing, t.relax.surfelBins);
  const std::vector<std::uint32_t> colour = clearedColours(s, t.relax.surfelBins);
  dropGhosts(f, s.surfelCells);
  std::copy(colour.begin(), colour.end(), f.colour.data());
}

}  // namespace thaw
