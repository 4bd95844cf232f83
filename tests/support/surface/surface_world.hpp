// SPDX-License-Identifier: Apache-2.0
// A scene on one rank whose particles a test moves directly, with whole surface updates as in a run.
#pragma once
#include "core/simulation/views/views.hpp"
#include "core/surface/update_surface.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {

struct SurfaceWorld {
  SerialSimulation simulation;
  World& w = simulation.world;
  SerialReducer& all = simulation.all;
  std::unique_ptr<SerialSurfaceRanks> ranks;
  SurfaceTools tools;

  explicit SurfaceWorld(const Scene& scene, const MeshLoader& load = {}) {
    w.scene = scene;
    simulation.prepare(load);
    simulation.start(load);
    ranks = std::make_unique<SerialSurfaceRanks>(w.surface.grid);
    tools.load = load;
    startSurface(surfaceView(w), ranks->halos(), tools);
  }
  SurfaceWorld(const SurfaceWorld&) = delete;
  Vec3d& place(std::size_t i) { return w.particles.position[i]; }
  void update() {
    w.clock.step++;
    updateSurface(surfaceView(w), ranks->halos(), tools);
  }
  const std::vector<SurfaceComponent>& components() const { return w.surface.components; }
};

}  // namespace thaw::test
