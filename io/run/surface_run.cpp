// SPDX-License-Identifier: Apache-2.0
#include "io/run/surface_run.hpp"

#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/views/views.hpp"
#include "core/solid/elasticity/active_solids.hpp"
#include "core/surface/surfel_velocities.hpp"
#include "io/frames/surface_frame.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/run/reports/surface_log.hpp"
#include "io/run/reports/surface_summary.hpp"

namespace thaw {

void beginSurface(Run& r, const MeshLoader& load) {
  r.surfaceTools.load = load;
  r.tools.times.start();
  startSurface(surfaceView(r.world), r.surface->halos(), r.surfaceTools);
  r.tools.times.lap(StepPhase::Setup);
  std::vector<std::string> warnings = mergedSheetWarnings(r.world.scene, r.surfaceTools.mergedSheets);
  for (std::string& line : pieceWarnings(r.world.scene, r.surfaceTools.pieces))
    warnings.push_back(std::move(line));
  for (const std::string& line : warnings) r.warn(line);
  onDisk(r, [&] {
    beginComponentLog(r.options.out);
    writeEventLog(r.options.out, r.world.surface.events);
  });
}

void resumeSurfaceOutput(Run& r) {
  onDisk(r, [&] {
    r.surfaceSeries = framesPresent(r.options.out, surfaceName(r.name), r.world.clock.time);
    r.summary.surface.volumeErrors = truncateComponentLog(r.options.out, r.world.clock.step);
    writeEventLog(r.options.out, r.world.surface.events);
  });
}

void updateSurfaceOf(Run& r) {
  Surface& s = r.world.surface;
  const std::size_t events = s.events.size();
  r.tools.times.start();
  if (r.world.modules.solid)
    findElasticEnergy(r.world.solids, r.world.bonds, r.tools.solid.elastic);  // also F, from which the
                                                                              // current volume of solids
                                                                              // follows
                                                                              // (gather_particles.cpp)
  if (r.world.modules.rigidify) deformPassive(r.tools.solid.elastic, r.world.solids, r.world.bonds);
  updateSurface(surfaceView(r.world), r.surface->halos(), r.surfaceTools);
  r.tools.times.lap(StepPhase::Surface);
  r.summary.surface.updatesHere++;
  if (s.events.size() != events) onDisk(r, [&] { writeEventLog(r.options.out, s.events); });
}

void writeSurfaceFrameOf(Run& r) {
  World& w = r.world;
  std::vector<Vec3d> velocities;
  if (wantsSurfelVelocities(w.scene))
    velocities = surfelVelocities(surfaceView(w), r.surface->halos(), r.surfaceTools);
  const std::string name = surfaceName(r.name), file = frameName(name, w.clock.frame);
  const Frame f = surfaceFrameOf(w.surface, w.clock, velocities);
  writeFrame(frameFolder(r.options.out) + "/" + file, r.comm.handle(), f, r.stamp());
  onDisk(r, [&] {
    r.surfaceSeries.push_back({file, w.clock.time});
    writeSeries(seriesPath(r.options.out, name), r.surfaceSeries);
    addToComponentLog(r.options.out, w.surface, w.clock);
    recordVolumes(r.summary.surface.volumeErrors, w.surface.components, w.clock.time);
  });
}

void removeSurfaceFrames(Run& r) {
  removeFramesAfter(r.options.out, surfaceName(r.name), r.surfaceSeries, r.world.clock.time);
  r.summary.surface.volumeErrors = truncateComponentLog(r.options.out, r.world.clock.step);
  writeEventLog(r.options.out, r.world.surface.events);
}

void gatherSurface(Run& r) {
  const World& w = r.world;
  if (!w.modules.surface) return;
  SurfaceSummary& s = r.summary.surface;
  std::int64_t surfels = static_cast<std::int64_t>(w.surface.surfels.owned);
  double seconds = r.tools.times[StepPhase::Surface];
  r.all.sum({&surfels, 1});
  r.all.maximum({&seconds, 1});
  s.phases = r.surfaceTools.times.seconds;
  r.all.maximum(s.phases);
  s.there = true;
  s.surfels = surfels;
  s.seconds = seconds;
  s.spacing = w.surface.spacing;
  s.keepsVolume = w.scene.surface.enforceVolume > 0;
  s.lastStep = w.surface.lastStep;
  s.counters = w.surface.counters;
  s.components = w.surface.components;
  s.events = w.surface.events;
}

}  // namespace thaw
