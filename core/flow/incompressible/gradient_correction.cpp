// SPDX-License-Identifier: Apache-2.0
#include "core/flow/incompressible/gradient_correction.hpp"

#include <algorithm>

#include "core/fluid/laws/free_surface.hpp"
#include "core/halo/exchange.hpp"
#include "core/walls/wall_forces.hpp"
#include "core/walls/wall_moments.hpp"

namespace thaw {
namespace {

/// Returns whether all eigenvalues exceed `least` (Sylvester's criterion).
bool eigenvaluesAbove(const Sym3d& m, double least) {
  const Sym3d r{m.xx - least, m.yy - least, m.zz - least, m.xy, m.yz, m.xz};
  return r.xx > 0 && r.xx * r.yy - r.xy * r.xy > 0 && determinant(full(r)) > 0;
}

/// Weight of the correction. It rises from 0 at a summed relative density of 0.9 to 1 at 0.95, since a free
/// surface truncates the sums. It is 0 if neighbours are on one side or the correction would be large.
float insideWeight(double relativeDensity, const Sym3d& moment, double asymmetry) {
  constexpr double leastEigenvalue = 0.4, outside = 0.9, width = 0.05;
  if (asymmetry > surfaceAsymmetry || !eigenvaluesAbove(moment, leastEigenvalue)) return 0;
  return static_cast<float>(std::clamp((relativeDensity - outside) / width, 0.0, 1.0));
}

/// Reduces the weight of the correction next to solids, from 1 at a distance of a support radius h to 0 at
/// 0.8 h. The corrected forces press particles to evenly spaced positions, so the first layers of liquid
/// would stick to a rising solid.
void clearBesideSolids(const PressureSystem& x) {
  const Continuum& p = x.particles;
  const NeighbourLists& lists = x.neighbours;
  constexpr double ramp = 0.2;
  const double h = x.grid.support;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::uint32_t l = 0; l < 8 && lists.fluid[g]; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || x.pressure.inside[i] == 0) continue;
      double nearest = h;
      for (std::uint32_t k = 0; k < lists.count[g]; k++) {
        const std::uint32_t j = lists.row(g, k, l);
        if (j != lists.dummy && p.phase[j] == Solid)
          nearest = std::min(nearest, length(p.position[j] - p.position[i]));
      }
      x.pressure.inside[i] *= static_cast<float>(std::max(0.0, 1 - (1 - nearest / h) / ramp));
    }
}

}  // namespace

void correctGradients(const PressureSystem& x) {
  constexpr Sym3d unit{1, 1, 1, 0, 0, 0};
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  const double h = x.grid.support;
  for (const WallSlope& wall : work.walls) work.impulse[wall.row] += wall.slope * 0.5;  // the wall's own part
  for (std::size_t i = 0; i < p.owned; i++) {
    work.inside[i] = 0;
    if (work.fraction[i] == 0 || p.phase[i] == Solid) continue;
    const double size = sizePerMoment * trace(work.moment[i]),
                 asymmetry = size > 0 ? h * length(work.impulse[i]) / size : 1;
    const auto row = static_cast<std::uint32_t>(i);
    work.moment[i] = alongAllWalls(work.moment[i], contactsOf(x.wallContacts, row), h);
    work.inside[i] = insideWeight(static_cast<double>(p.relativeDensity[i]), work.moment[i], asymmetry);
  }
  for (const WallSlope& wall : work.walls) work.impulse[wall.row] -= wall.slope * 0.5;
  if (x.modules.solid) {
    if (x.modules.melting)
      refresh(x.halos.cells, p, ColumnList{&p.phase}).wait();  // the owners have changed
                                                               // the phase
    clearBesideSolids(x);
  }
  for (std::size_t i = 0; i < p.owned; i++)
    p.correction[i] = work.inside[i] > 0 ? single(static_cast<double>(work.inside[i]) *
                                                  (symmetric(inverse(full(work.moment[i]))) - unit))
                                         : Sym3f{};
  refresh(x.halos.cells, p, ColumnList{&p.correction}).wait();
}

}  // namespace thaw
