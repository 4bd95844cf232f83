// SPDX-License-Identifier: Apache-2.0
#include "core/surface/update_components.hpp"

#include <algorithm>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/measures/measure.hpp"
#include "core/surface/measures/surfel_area.hpp"
#include "core/surface/relaxation/enforce_volume.hpp"
#include "core/surface/relaxation/wall_projection.hpp"
#include "core/surface/topology/components.hpp"
#include "core/surface/topology/merge.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

void addSurfelGhosts(Surface& s, SurfaceHalos halos) {
  Surfels& f = s.surfels;
  ColumnList columns{&f.id, &f.position, &f.normal, &f.radius, &f.component};
  if (f.liquid.active) columns.push_back(&f.liquid);
  addGhosts(halos.surfels, f, s.surfelCells, columns);
}

void placeSurfels(Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, t.sort);
  addSurfelGhosts(s, halos);
}

/// Measures areas and components at current positions. Requires: ghosts.
void measureAll(Surface& s, SurfaceHalos halos, TopologyTools& t, bool again = false) {
  findSurfelAreas(s, halos.all, t.areas, again);
  measureComponents(s, halos.all);
}

/// Offsets surfels until the volumes agree, at most four times.
void enforceVolume(const SurfaceView& w, SurfaceHalos halos, TopologyTools& t, bool start) {
  Surface& s = w.surface;
  std::vector<VolumeMove> moves;
  for (int k = 0; k < 4 && volumesDeviate(s, start); k++) {
    offsetToVolume(s, t.areas.bins, w.scene.surface.enforceVolume, w.scene.spacing, start, moves);
    reprojectOutOfWalls(w);
    refreshGhosts(halos.surfels, s.surfels, ColumnList{&s.surfels.position});
    measureAll(s, halos, t, true);
  }
}

/// Passes the offset of a component to its separated parts. The offset is limited to leastOffset, because a
/// further level rise belongs to the component itself.
void inheritIsoOffset(Surface& s, double spacing, const std::vector<SurfaceComponent>& before,
                      const ComponentTools& c) {
  const auto find = [&](std::uint64_t label) {
    const auto at = std::lower_bound(before.begin(), before.end(), label,
                                     [](const SurfaceComponent& x, std::uint64_t l) { return x.label < l; });
    return at != before.end() && at->label == label ? &*at : nullptr;
  };
  for (SurfaceComponent& k : s.components) {
    if (find(k.label)) continue;
    for (const ComponentTools::Piece& p : c.pieces)
      if (const SurfaceComponent* from = p.part == k.label ? find(p.from) : nullptr) {
        k.isoOffset = std::max(from->isoOffset, leastOffset * spacing);
        break;
      }
  }
}

}  // namespace

void labelParticles(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& tools) {
  Surface& s = w.surface;
  TopologyTools& t = tools.topology;
  placeSurfels(s, halos, tools);
  placeParticles(w.surface, halos, tools);
  ColumnList columns{&s.particles.id, &s.particles.position, &s.particles.component, &s.particles.body};
  if (s.particles.liquid.active) columns.push_back(&s.particles.liquid);
  addGhosts(halos.particles, s.particles, s.particleCells, columns);
  labelNewParticles(w.scene, w.surface, halos, t.components);
  findParts(w.scene, w.surface, halos, t.components);
  attachEnclosed(w.surface, halos, t.components);
  splitComponents(w.clock, w.surface, halos, t.components);
  dropGhosts(s.particles, s.particleCells);
  // Components have changed, and ghosts are gone.
  tools.relax.particlesPrepared = false;
}

void splitAndMerge(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& tools) {
  Surface& s = w.surface;
  TopologyTools& t = tools.topology;
  s.changesBefore = s.counters.splits + s.counters.merges;
  const std::vector<SurfaceComponent> before = s.components;
  labelParticles(w, halos, tools);
  // splitComponents has removed the ghosts of surfels.
  addSurfelGhosts(s, halos);
  if (t.components.several()) {
    addGhosts(halos.particles, s.particles, s.particleCells,
              ColumnList{&s.particles.id, &s.particles.position, &s.particles.component});
    fillBins(s.particles.position.data(), s.particles.size(), w.scene.surface.linkLength * w.scene.spacing,
             t.components.particleBins);
  }
  mergeComponents(w, halos, t.components, t.merge);
  dropGhosts(s.particles, s.particleCells);
  // Contact has moved some surfels.
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, tools.sort);
  // Components have only counts and positions for now.
  clearAreas(s.surfels);
  measureComponents(s, halos.all);
  inheritIsoOffset(s, w.scene.spacing, before, t.components);
}

void measureSurface(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& tools, bool start) {
  Surface& s = w.surface;
  TopologyTools& t = tools.topology;
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, tools.sort);
  // Surfels may have crossed periodic sides.
  reprojectOutOfWalls(w);
  addSurfelGhosts(s, halos);
  placeParticles(w.surface, halos, tools);
  measureAll(s, halos, t);
  if (w.scene.surface.enforceVolume > 0 && s.lastStep >= 0) enforceVolume(w, halos, t, start);
  dropGhosts(s.surfels, s.surfelCells);
}

void updateComponents(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& tools) {
  splitAndMerge(w, halos, tools);
  measureSurface(w, halos, tools);
}

}  // namespace thaw
