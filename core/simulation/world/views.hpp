// SPDX-License-Identifier: Apache-2.0
// The parts of a run's data that each module uses.
#pragma once
#include "core/oriented/data/oriented_view.hpp"
#include "core/sheet/data/sheet_view.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

inline OrientedView orientedView(World& w, StepTools& t) {
  return {w.oriented, t.oriented, w.particles, w.ledger, w.counters, t.sort, t.times,
          w.scene,    w.modules,  w.grid,      w.cells,  w.walls,    w.clock};
}

inline SheetView sheetView(World& w) {
  return {w.sheets, w.particles, w.oriented, w.ledger, w.scene, w.modules, w.grid, w.cells, w.walls, w.clock};
}

}  // namespace thaw
