// SPDX-License-Identifier: Apache-2.0
// The parts of a run that modules use, as their views.
#pragma once
#include "core/simulation/world/world.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

inline SurfaceView surfaceView(World& w) {
  return {w.scene, w.modules, w.grid, w.walls, w.clock, w.particles, w.solids, w.surface};
}

}  // namespace thaw
