// SPDX-License-Identifier: Apache-2.0
#include "core/surface/update_surface.hpp"

#include "core/surface/advection/displace.hpp"
#include "core/surface/advection/gather_particles.hpp"
#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/blend.hpp"
#include "core/surface/relaxation/enforce_volume.hpp"
#include "core/surface/relaxation/relax.hpp"
#include "core/surface/relaxation/wall_projection.hpp"
#include "core/surface/resampling/clear_isolated_colours.hpp"
#include "core/surface/resume_surface.hpp"
#include "core/surface/seeding/grow.hpp"
#include "core/surface/seeding/resurface_exposed.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "core/surface/start_pieces.hpp"
#include "core/surface/update_components.hpp"

namespace thaw {
namespace {

/// Migrates surfels and particle copies to the ranks of their cells, without ghosts.
void placeAll(Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, t.sort);
  placeParticles(s, halos, t);
}

/// Labels the components of particles before surfels exist. Temporary surfels connect bodies that are too
/// thin for their particles.
void labelStart(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  t.pieces = findStartPieces(w, halos, t);
  const SurfaceCounters before = s.counters;
  if (!t.pieces.empty()) sampleMeshes(w.scene, s, t.load, halos.all);
  labelParticles(w, halos, t);
  s.counters = before;
  s.surfels.resize(s.surfels.owned, 0);
  s.surfels.resize(0, 0);
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, t.sort);
}

/// Resamples sampled surfels at the start. Otherwise, the first update would create and delete surfels of a
/// body at rest. With adaptive density, each call halves the distance of radii to the target from curvature.
void resampleStart(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  const SurfaceCounters before = w.surface.counters;
  const bool adapt = w.scene.surface.adapt > 0;
  for (int k = 0; k < (adapt ? 4 : 2); k++) resampleOnParticles(w, halos, t, 10);
  putBirthsOnShapes(w.scene, w.surface, t.load);
  // The initial surface does not count as a change.
  w.surface.counters = before;
  if (adapt) updateComponents(w, halos, t);
  else measureSurface(w, halos, t);
}

/// Enforces the volume of grown surfaces. Surfaces whose rims moved together are resampled once more.
void enforceStartVolume(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  const bool off = w.scene.surface.enforceVolume > 0 && volumesDeviate(w.surface, true);
  measureSurface(w, halos, t, true);
  if (!off) return;
  const SurfaceCounters before = w.surface.counters;
  resampleOnParticles(w, halos, t, 10);
  w.surface.counters = before;
  measureSurface(w, halos, t, true);
}

/// Removes the reference of surfels that relaxed next to a seam or a crack.
void dropReferences(Surfels& f) {
  if (!f.relaxesOnce.active || !f.hasReference.active) return;
  for (std::size_t i = 0; i < f.owned; i++)
    if (f.relaxesOnce[i]) f.hasReference[i] = 0;
}

/// Moves particle copies from the previous to current positions.
void advanceParticles(Surface& s) {
  for (std::size_t i = 0; i < s.particles.owned; i++) s.particles.position[i] += s.particles.displacement[i];
}

}  // namespace

void startSurface(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  gatherParticles(w, halos.all.rank());
  partitionByParticles(s, halos, t);
  labelStart(w, halos, t);
  growBodies(w, halos, t);
  sampleMeshes(w.scene, s, t.load, halos.all);
  updateComponents(w, halos, t);
  resampleStart(w, halos, t);
  recordStartVolumes(w.scene, w.particles, w.surface, halos);
  placeAll(s, halos, t);
  sampleFields(w.scene, w.surface, halos, t);
  s.lastStep = w.clock.step;
  projectOutOfWalls(w, t.relax.particleBins);
  enforceStartVolume(w, halos, t);
  recordReference(w.particles, w.surface);
  returnParticles(w.particles, w.solids, w.surface, halos);
}

void updateSurface(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  t.times.start();
  balanceSurface(s, halos, t, false);
  resetMeltedShares(w.scene, w.particles);
  gatherParticles(w, halos.all.rank());
  removeWallOffsets(s.surfels);
  placeAll(s, halos, t);
  t.times.lap(SurfacePhase::Place);
  findDisplacementGradients(w.grid, w.surface, halos, t);
  fadeFill(s.particles);
  displaceSurfels(w.scene, w.surface, halos, t);
  t.times.lap(SurfacePhase::Displacement);
  advanceParticles(s);
  placeAll(s, halos, t);
  t.times.lap(SurfacePhase::Place);
  // splitting and merging come before resampling, which closes seams
  splitAndMerge(w, halos, t);
  listIsoOffsets(w.scene, w.surface, t.relax.isoOffset);
  t.times.lap(SurfacePhase::Components);
  prepareParticles(w.scene, w.surface, halos, t);
  t.times.lap(SurfacePhase::Fields);
  renewSurfels(w, halos, t);
  const std::int64_t resurfaced = resurfaceExposed(w, halos, t);
  t.times.lap(SurfacePhase::Growth);
  // Before the iterations, resampling closes seams of merges and new faces. Afterwards, it closes holes from
  // motion.
  if (s.counters.splits + s.counters.merges > s.changesBefore || resurfaced > 0)
    resampleOnParticles(w, halos, t, 24);
  t.times.lap(SurfacePhase::Resampling);
  listIsoOffsets(w.scene, w.surface, t.relax.isoOffset);
  const RelaxationResult relaxed = relaxSurfels(w, halos, t, forceWeights(w.scene.surface),
                                                w.scene.surface.iterations, false);
  dropReferences(s.surfels);
  deactivate(s.surfels.relaxesOnce);
  s.counters.iterations += relaxed.iterations;
  s.counters.unfinished += !relaxed.finished;
  blendSurfels(s.surfels);
  t.times.lap(SurfacePhase::Iterations);
  resampleOnParticles(w, halos, t, 8);
  clearIsolatedColours(w.scene, w.surface, halos, t);
  t.times.lap(SurfacePhase::Resampling);
  projectOutOfWalls(w, t.relax.particleBins);
  measureSurface(w, halos, t);
  t.times.lap(SurfacePhase::Measures);
  returnParticles(w.particles, w.solids, w.surface, halos);
  t.times.lap(SurfacePhase::Place);
  s.counters.updates++;
  s.lastStep = w.clock.step;
}

}  // namespace thaw
