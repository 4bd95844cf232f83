// SPDX-License-Identifier: Apache-2.0
// The parts of a run's data that each module uses.
#pragma once
#include "core/sheet/data/sheet_view.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

inline SheetView sheetView(World& w) {
  return {w.sheets, w.particles, w.oriented, w.ledger, w.scene, w.modules, w.grid, w.cells, w.walls, w.clock};
}

}  // namespace thaw
