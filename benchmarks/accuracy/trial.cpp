// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/accuracy/trial.hpp"

#include <cmath>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "benchmarks/accuracy/made_meshes.hpp"
#include "core/math/exact_sum.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/surface_due.hpp"
#include "core/time/frame_times.hpp"
#include "io/scene/scene_for_all.hpp"
#include "parallel/balance.hpp"

namespace thaw::accuracy {
namespace {

/// Processor time (s) of this process, which does not depend on other load of the machine.
double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double overRanks(Trial& r, double seconds) {
  ExactSum all;
  all.add(seconds);
  all.carry();
  r.all.sum(all.digit);
  return all.value();
}

/// Counts due frames. The surface is updated at frames, as in a run that writes them.
void countFrames(Clock& c) {
  while (frameDue(c)) c.frame++;
}

void beginSurface(Trial& r) {
  World& w = r.world;
  r.surface = std::make_unique<SurfaceRanks>(r.comm, w.surface.grid);
  r.surfaceTools.load = suiteMeshes();
  startSurface(surfaceView(w), r.surface->halos(), r.surfaceTools);
  countFrames(w.clock);
}

void surfaceAfterStep(Trial& r, double move2) {
  World& w = r.world;
  if (!frameDue(w.clock) && !surfaceDue(w.scene, w.clock, w.grid, w.surface, move2) &&
      w.clock.time < w.clock.end)
    return;
  const double begin = processorSeconds();
  if (w.modules.solid) findElasticEnergy(w.solids, w.bonds, r.tools.solid.elastic);
  updateSurface(surfaceView(w), r.surface->halos(), r.surfaceTools);
  r.updateSeconds += processorSeconds() - begin;
  countFrames(w.clock);
}

/// Returns the path of a scene of this name (without .toml) in a folder of scenes/.
std::string sceneFile(const std::string& name) {
  const std::string scenes = std::string(THAW_BENCHMARK_FOLDER) + "/scenes";
  for (const auto& folder : std::filesystem::directory_iterator(scenes))
    if (const auto file = folder.path() / (name + ".toml"); std::filesystem::exists(file))
      return file.string();
  throw std::runtime_error("no folder of " + scenes + " has " + name + ".toml");
}

}  // namespace

void run(const Case& c, Trial& r, const std::vector<std::string>& overrides) {
  const std::string file = sceneFile(c.scene ? c.scene : c.name);
  World& w = r.world;
  r.overrides = overrides;
  w.scene = sceneForAll(r.comm, file, overrides);
  if (c.adapt) c.adapt(w.scene);
  r.prepare(suiteMeshes());
  r.start(suiteMeshes(), [&](Continuum&) {
    if (c.place) c.place(r);
  });
  if (c.start) {
    c.start(r);
    initializeForces(w, r.halos(), r.tools);
  }
  WorkMeter meter;
  const double begin = processorSeconds();
  if (w.modules.surface) beginSurface(r);
  if (c.watch) c.watch(r);
  while (w.clock.time < w.clock.end && r.finite) {
    const StepOutcome o = r.step();
    r.finite = o.finite;
    if (r.finite && w.modules.surface) surfaceAfterStep(r, o.surfaceMove2);
    if (c.watch) c.watch(r);
    if (w.clock.step % 25 == 0) balance(w, *r.tables.cells, r.tools, meter);
  }
  r.coreSeconds = overRanks(r, processorSeconds() - begin);
  r.updateSeconds = overRanks(r, r.updateSeconds);
}

void makeThin(Scene& s) {
  const double width = std::max(6.0, std::ceil(3 * s.numerics.support)) * s.spacing;  // three cells
  for (int a = 0; a < 3; a++) {
    if (s.domain.side[static_cast<std::size_t>(a)][0] != Side::Periodic) continue;
    s.domain.min[a] = 0;
    s.domain.max[a] = width;
    for (Body& b : s.bodies) {
      b.shape.size[a] = width;
      b.shape.move[a] = 0.5 * width;
    }
  }
}

double sum(Trial& r, const OfParticle& f) {
  ExactSum s;
  for (std::size_t i = 0; i < r.world.particles.owned; i++) s.add(f(r.world, i));
  s.carry();
  r.all.sum(s.digit);
  return s.value();
}

double largest(Trial& r, const OfParticle& f) {
  double most = -never;
  for (std::size_t i = 0; i < r.world.particles.owned; i++) most = std::max(most, f(r.world, i));
  r.all.maximum({&most, 1});
  return most;
}

double rootMeanSquare(Trial& r, const OfParticle& f) {
  const double n = sum(r, [](const World&, std::size_t) { return 1.0; });
  return std::sqrt(sum(r,
                       [&](const World& w, std::size_t i) {
                         const double v = f(w, i);
                         return v * v;
                       }) /
                   n);
}

}  // namespace thaw::accuracy
