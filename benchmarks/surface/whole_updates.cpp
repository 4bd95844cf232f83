// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/surface/whole_updates.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>

#include "core/simulation/setup/serial_simulation.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/update_surface.hpp"
#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double smoothStep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Advances the particles by at most `step` (m).
void deform(World& w, bool molten, double bottom, double height, double step) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    Vec3d& x = p.position[i];
    const double z = (x.z - bottom) / height;
    if (molten) {
      const double share = smoothStep((0.7 - z) / 0.1), reach = 0.5 * height;
      x += (step * share / reach) * Vec3d{0.5 * x.x, 0.5 * x.y, -(x.z - bottom)};
    } else {
      const double angle = 2 * std::numbers::pi / 50;
      x = {std::cos(angle) * x.x - std::sin(angle) * x.y, std::sin(angle) * x.x + std::cos(angle) * x.y,
           x.z - 0.1 * step};
    }
  }
}

}  // namespace

WholeUpdates wholeUpdates(bool molten, double surfels, double support, std::int64_t updates) {
  // a spacing of 5.5 mm gives 60,000 surfels
  const double spacing = 0.0055 * std::sqrt(60000 / surfels);
  SerialSimulation simulation;
  World& w = simulation.world;
  w.scene = readScene(
      std::string(THAW_BENCHMARK_FOLDER) + "/../../scenes/keiser/melting_fast.toml",
      {"surface.spacing=" + std::to_string(spacing), "surface.support=" + std::to_string(support)});
  simulation.prepare({});
  sampleWorld(w, simulation.halos(), simulation.tools, {});
  SerialSurfaceRanks ranks(w.surface.grid);
  SurfaceTools t;
  WholeUpdates out;
  double begin = processorSeconds();
  startSurface(surfaceView(w), ranks.halos(), t);
  out.startSeconds = processorSeconds() - begin;
  Continuum& p = w.particles;
  double bottom = 1e300, top = -1e300;
  for (std::size_t i = 0; i < p.owned; i++)
    bottom = std::min(bottom, p.position[i].z), top = std::max(top, p.position[i].z);
  const double height = top - bottom;
  if (molten)
    for (std::size_t i = 0; i < p.owned; i++)
      p.liquid[i] = static_cast<float>(smoothStep((0.7 - (p.position[i].z - bottom) / height) / 0.1));
  const std::int64_t before = 3;
  std::int64_t iterations = 0, unfinished = 0;
  for (std::int64_t k = 0; k < before + updates; k++) {
    deform(w, molten, bottom, height, 0.25 * w.grid.support);
    w.clock.step++;
    if (k == before)
      t.times = {}, iterations = w.surface.counters.iterations, unfinished = w.surface.counters.unfinished;
    begin = processorSeconds();
    updateSurface(surfaceView(w), ranks.halos(), t);
    const double took = processorSeconds() - begin;
    if (k < before) continue;
    out.seconds += took / static_cast<double>(updates);
    out.worst = std::max(out.worst, took);
    out.surfels += static_cast<double>(w.surface.surfels.owned) / static_cast<double>(updates);
  }
  const double n = static_cast<double>(updates);
  out.particles = static_cast<double>(p.owned);
  out.surfelNeighbours = 3.6276 * support * support;
  out.iterations = static_cast<double>(w.surface.counters.iterations - iterations) / n;
  out.finished = 1 - static_cast<double>(w.surface.counters.unfinished - unfinished) / n;
  for (std::size_t k = 0; k < surfacePhases; k++) out.phase[k] = t.times.seconds[k] / n;
  out.updates = updates;
  return out;
}

}  // namespace thaw
