// SPDX-License-Identifier: Apache-2.0
// The data of a step that sleep reads and changes.
#pragma once
#include <cstdint>
#include <vector>

#include "core/ledger/counters.hpp"
#include "core/ledger/ledger.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/scene.hpp"
#include "core/sleep/sleep.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct SleepView {
  const Scene& scene;
  const CellGrid& grid;
  Continuum& particles;
  const CellTable& cells;
  NeighbourLists& neighbours;
  const Solids& solids;
  const Bonds& bonds;
  const Walls& walls;
  const Clock& clock;
  Ledger& ledger;
  Counters& counters;
  SleepWork& sleep;
  std::vector<std::uint8_t>& inner;  ///< by cell: SearchInput::inner
  const WallContacts& wallContacts;
};

}  // namespace thaw
