// SPDX-License-Identifier: Apache-2.0
// Data of a step that rigid pieces read and change.
#pragma once
#include "core/ledger/counters.hpp"
#include "core/ledger/ledger.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/rigid/data/pieces.hpp"
#include "core/rigid/data/rigid_work.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct RigidView {
  const Scene& scene;
  const CellGrid& grid;
  Continuum& particles;
  const CellTable& cells;
  Pieces& pieces;
  const Walls& walls;
  Ledger& ledger;
  RigidWork& work;
  const Modules& modules;
  const Clock& clock;
  Counters& counters;
};

}  // namespace thaw
