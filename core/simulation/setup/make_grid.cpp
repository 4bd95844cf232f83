// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/make_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/math/digits.hpp"
#include "core/oriented/laws/oriented_reach.hpp"
#include "core/sheet/data/plan_sheets.hpp"

namespace thaw {
namespace {

/// Returns the reason for which a periodic domain is too thin, with the thinnest possible slab in spacings if
/// known.
std::string slabAdvice(double reach, double spacing) {
  const std::string farthest =
      "three times the largest interaction range (`numerics.support`; for surfels "
      "`surface.particle_support`)";
  return spacing > 0 ? ", " + inDigits(3 * reach / spacing) + " spacings: " + farthest : ", " + farthest;
}

}  // namespace

CellGrid makeGrid(const Scene& s, double least) {
  const double reach = std::max({orientedReach(s), sheetReach(s), least});
  double support = s.numerics.support * s.spacing;
  // Without continuum particles, cells of their support would each hold thousands of particles of a much
  // finer body.
  if (s.bodies.empty() && s.emitters.empty() && reach > 0 && reach < 0.25 * support) support = reach;
  return makeGrid(s.domain, support, reach, s.spacing);
}

CellGrid makeGrid(const Domain& d, double support, double least, double spacing) {
  CellGrid g;
  g.support = support;
  const double cell = std::max(support, least);
  for (int a = 0; a < 3; a++) {
    const std::string axis(1, static_cast<char>('x' + a));
    const double extent = d.max[a] - d.min[a];
    if (!(extent > 0))
      throw std::runtime_error("the domain has no extent along " + axis + ": `max` must be above `min`");
    if (extent / cell > maxCellsPerAxis - 8)
      throw std::runtime_error("the domain is " + inDigits(extent / cell) + " support radii long along " +
                               axis + "; expected at most " + std::to_string(maxCellsPerAxis) +
                               ": reduce the domain or increase the spacing");
    g.periodic[a] = d.side[a][0] == Side::Periodic;
    if (g.periodic[a]) {
      g.cells[a] = static_cast<int>(std::floor(extent / cell * (1 + 1e-12)));
      if (g.cells[a] < 3)
        throw std::runtime_error("the domain is periodic along " + axis +
                                 " but shorter than three support radii: it is " + inDigits(extent) +
                                 " m long; expected at least " + inDigits(3 * cell) + " m" +
                                 slabAdvice(cell, spacing));
      g.edge[a] = extent / g.cells[a];
      g.origin[a] = d.min[a];
      g.period[a] = extent;
    } else {  // with a margin of one cell, for particles pressed into a wall
      g.edge[a] = cell;
      g.cells[a] = static_cast<int>(std::ceil(extent / cell)) + 2;
      g.origin[a] = d.min[a] - cell;
    }
  }
  return g;
}

}  // namespace thaw
