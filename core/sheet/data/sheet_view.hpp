// SPDX-License-Identifier: Apache-2.0
// Data of a run on one rank that sheets use in a step.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/neighbours/grid.hpp"
#include "core/oriented/data/oriented.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/sheet/data/sheets.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// References to data of the run; a const view still allows changes of data that is not const here.
struct SheetView {
  SheetBodies& sheets;
  Continuum& particles;
  OrientedBodies& oriented;
  Ledger& ledger;
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  const CellTable& cells;  ///< for the continuum
  const Walls& walls;
  const Clock& clock;
};

}  // namespace thaw
