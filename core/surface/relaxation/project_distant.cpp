// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/project_distant.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/field/iso_surface.hpp"
#include "core/surface/relaxation/surfel_move.hpp"
#include "core/surface/relaxation/wall_projection.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

/// Distance to the surface, in spacings of surfels, below which the forces take over.
constexpr double nearEnough = 0.3;
/// Number of steps of half a particle spacing each, for which the grid's cells are large enough
/// (prepareSurface).
constexpr int projectionSteps = 5;

/// One step of Newton's method for the surfels of a group, within `room` (m) of their sorted positions.
/// Surfels that reach the surface, or have none nearby, are no longer stoppedAtMargin.
void projectionStep(const SurfaceView& w, FieldProbe& probe, const std::uint32_t* rows, std::size_t n,
                    double isoOffset, double room) {
  Surfels& f = w.surface.surfels;
  const double enough = nearEnough * w.surface.spacing;
  std::array<std::uint32_t, FieldProbe::most> row;
  std::array<Vec3d, FieldProbe::most> start, x;
  std::array<FieldSample, FieldProbe::most> field;
  for (std::size_t k = 0; k < n; k++) row[k] = rows[k], start[k] = x[k] = f.position[rows[k]];
  for (int round = 0; round < 6 && n > 0; round++) {
    probe.at(x.data(), n, field.data());
    std::size_t left = 0;
    for (std::size_t k = 0; k < n; k++) {
      const std::uint32_t i = row[k];
      const std::optional<IsoStep> step = isoStep(field[k], w.surface.particleSupport, isoOffset, room);
      f.moving[i] = 1;
      if (!step || dot(step->outward, f.normal[i]) < 0) continue;
      Vec3d to = x[k] + step->outward * step->out;
      const double gone = length(to - start[k]);
      if (gone > room) to = start[k] + (to - start[k]) * (room / gone);
      f.position[i] = projectedOutOfWalls(w, to, step->outward);
      f.normal[i] = step->outward;
      if (std::abs(step->out) <= enough) continue;
      if (gone > room) {
        f.moving[i] = stoppedAtMargin;
        continue;
      }
      row[left] = i, start[left] = start[k], x[left] = to;
      left++;
    }
    n = left;
  }
}

}  // namespace

void projectDistantSurfels(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  RelaxTools& r = t.relax;
  const double room = 0.5 * w.scene.spacing;
  f.resize(f.owned, 0);
  FieldProbe probe(w.scene, w.surface, t);
  double going = 1;
  for (int leg = 0; leg < projectionSteps && going > 0; leg++) {
    placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
    r.free.assign(f.owned, 0);
    for (std::size_t i = 0; i < f.owned; i++) {
      if (f.moving[i] != stoppedAtMargin) continue;
      f.stepShare[i] = 0;
      r.free[i] = f.gapCutoff[i] == std::numeric_limits<float>::infinity();
    }
    listGroups(s, r.free, r.particleBins, r.particleBins, {0, s.particleSupport + room}, r.lists);
    going = 0;
    for (std::size_t g = 0; g < r.lists.groups(); g++) {
      const std::uint32_t* rows = &r.lists.self[8 * g];
      const std::size_t lanes = r.lists.lanes[g];
      probe.selectRows(r.lists.particle.data() + r.lists.firstParticle[g],
                       r.lists.firstParticle[g + 1] - r.lists.firstParticle[g], f.component[rows[0]]);
      projectionStep(w, probe, rows, lanes,
                     w.scene.spacing *
                         limitedIsoOffset(isoOffsetOf(r.isoOffset, f.component[rows[0]]) / w.scene.spacing),
                     room);
      for (std::size_t k = 0; k < lanes; k++)
        if (f.moving[rows[k]] == stoppedAtMargin) going = 1;
    }
    halos.all.maximum({&going, 1});
  }
}

}  // namespace thaw
