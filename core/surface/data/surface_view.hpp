// SPDX-License-Identifier: Apache-2.0
// Parts of a run that an update of the surface uses.
#pragma once
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// References to the data of a run on one rank. surfaceView creates it (core/simulation/views/views.hpp). It
/// is valid as long as the data.
struct SurfaceView {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;  ///< cells of the particles; the surface has its own grid
  const Walls& walls;
  const Clock& clock;
  Continuum& particles;
  Solids& solids;
  Surface& surface;
};

}  // namespace thaw
