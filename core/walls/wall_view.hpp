// SPDX-License-Identifier: Apache-2.0
// The data of a run on which walls act.
#pragma once
#include "core/ledger/counters.hpp"
#include "core/ledger/ledger.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct WallView {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  Continuum& particles;
  const CellTable& cells;
  Solids& solids;
  const Walls& walls;
  Ledger& ledger;
  Counters& counters;
};

}  // namespace thaw
