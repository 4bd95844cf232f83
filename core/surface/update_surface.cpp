#include "core/surface/update_surface.hpp"

#include "core/surface/blend.hpp"
#include "core/surface/clear_specks.hpp"
#include "core/surface/cover_bare.hpp"
#include "core/surface/displace.hpp"
#include "core/surface/follow_start.hpp"
#include "core/surface/gather_particles.hpp"
#include "core/surface/grow.hpp"
#include "core/surface/keep_out.hpp"
#include "core/surface/keep_volume.hpp"
#include "core/surface/place_rows.hpp"
#include "core/surface/ready_particles.hpp"
#include "core/surface/relax.hpp"
#include "core/surface/resume_surface.hpp"
#include "core/surface/sample_mesh.hpp"
#include "core/surface/update_components.hpp"

namespace thaw {
namespace {

/// Surfels and copies on the ranks that own their cells, without ghosts.
void placeAll(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, t.sort);
  placeParticles(w, halos, t);
}

/// The components of the particles, before there are surfels. What hangs together of a body that is too thin
/// for its particles its surfels say: they are sampled for that alone, and taken away.
void labelStart(World& w, SurfaceHalos halos, SurfaceTools& t) {
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

/// Surfels that were sampled are to be in order before anything moves: else the first update would bear and
/// delete some of a body that is at rest. Their density follows the curvature, where it is to: it goes half
/// of the way in a call.
void orderStart(World& w, SurfaceHalos halos, SurfaceTools& t) {
  const SurfaceCounters before = w.surface.counters;
  const bool adapt = w.scene.surface.adapt > 0;
  for (int k = 0; k < (adapt ? 4 : 2); k++) resampleOnParticles(w, halos, t, 10);
  putBirthsOnShapes(w.scene, w.surface, t.load);
  w.surface.counters = before;  // the start is no change
  if (adapt) updateComponents(w, halos, t);
  else measureSurface(w, halos, t);
}

/// Volume keeping of what is grown from particles. Where that moves rims together, surfels are put in order
/// once more.
void holdStart(World& w, SurfaceHalos halos, SurfaceTools& t) {
  const bool off = w.scene.surface.keepVolume > 0 && volumesAreOff(w.surface, true);
  measureSurface(w, halos, t, true);
  if (!off) return;
  const SurfaceCounters before = w.surface.counters;
  resampleOnParticles(w, halos, t, 10);
  w.surface.counters = before;
  measureSurface(w, halos, t, true);
}

/// What settled beside a seam or a crack has another place than it had at the start.
void letLooseGo(Surfels& f) {
  if (!f.loose.active || !f.follows.active) return;
  for (std::size_t i = 0; i < f.owned; i++)
    if (f.loose[i]) f.follows[i] = 0;
}

/// From where the particles were at the last update to where they are.
void bringParticlesForward(Surface& s) {
  for (std::size_t i = 0; i < s.particles.owned; i++) s.particles.position[i] += s.particles.displacement[i];
}

}  // namespace

void startSurface(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  gatherParticles(w, halos.all.rank());
  cutByParticles(w, halos, t);
  labelStart(w, halos, t);
  growBodies(w, halos, t);
  sampleMeshes(w.scene, s, t.load, halos.all);
  updateComponents(w, halos, t);
  orderStart(w, halos, t);
  keepStartVolumes(w, halos);
  placeAll(w, halos, t);
  sampleFields(w, halos, t);
  s.lastStep = w.clock.step;
  keepOutOfWalls(w, t.relax.particleBins);
  holdStart(w, halos, t);
  keepStart(w);
  returnParticles(w, halos);
}

void updateSurface(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  t.times.start();
  balanceSurface(w, halos, t, false);
  settleShares(w);
  gatherParticles(w, halos.all.rank());
  releasePressed(s.surfels);
  placeAll(w, halos, t);
  t.times.lap(SurfacePhase::Place);
  findDisplacementGradients(w, halos, t);
  fadeFill(s.particles);
  displaceSurfels(w, halos, t);
  t.times.lap(SurfacePhase::Displacement);
  bringParticlesForward(s);
  placeAll(w, halos, t);
  t.times.lap(SurfacePhase::Place);
  splitAndMerge(w, halos, t);  // before resampling, which closes seams
  listRaised(w, t.relax.raised);
  t.times.lap(SurfacePhase::Components);
  readyParticles(w, halos, t);
  t.times.lap(SurfacePhase::Fields);
  renewSurfels(w, halos, t);
  const std::int64_t bare = coverBare(w, halos, t);
  t.times.lap(SurfacePhase::Growth);
  // seams of merges and of new faces close before the iterations; what the motion has opened, after them
  if (s.counters.splits + s.counters.merges > s.changesBefore || bare > 0)
    resampleOnParticles(w, halos, t, 24);
  t.times.lap(SurfacePhase::Resampling);
  listRaised(w, t.relax.raised);
  const Settled settled = settle(w, halos, t, forceWeights(w.scene.surface), w.scene.surface.iterations,
                                 false);
  letLooseGo(s.surfels);
  deactivate(s.surfels.loose);
  s.counters.iterations += settled.iterations;
  s.counters.unfinished += !settled.finished;
  blendSurfels(w);
  t.times.lap(SurfacePhase::Iterations);
  resampleOnParticles(w, halos, t, 8);
  clearSpecks(w, halos, t);
  t.times.lap(SurfacePhase::Resampling);
  keepOutOfWalls(w, t.relax.particleBins);
  measureSurface(w, halos, t);
  t.times.lap(SurfacePhase::Measures);
  returnParticles(w, halos);
  t.times.lap(SurfacePhase::Place);
  s.counters.updates++;
  s.lastStep = w.clock.step;
}

}  // namespace thaw
