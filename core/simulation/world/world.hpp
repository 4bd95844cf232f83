// SPDX-License-Identifier: Apache-2.0
// The data of a run on one rank.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/ledger/counters.hpp"
#include "core/ledger/ledger.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/oriented/data/oriented.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/rigid/data/pieces.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/sheet/data/sheets.hpp"
#include "core/simulation/world/monitor_state.hpp"
#include "core/surface/data/surface.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct World {
  Scene scene;
  Modules modules;
  CellGrid grid;
  Continuum particles;
  CellTable cells;
  NeighbourLists neighbours;
  Solids solids;
  Bonds bonds;
  Pieces pieces;
  Walls walls;
  std::vector<float> initialSummedDensity;  ///< with carried densities: summed relative density at the start,
                                            ///< by owned row; kept until it is checked
  Clock clock;
  Ledger ledger;
  Counters counters;
  MonitorState monitor;
  Surface surface;
  OrientedBodies oriented;
  SheetBodies sheets;
  PressureIterations pressureIterations;
  bool interactionHasCompression = true;  ///< true: Continuum::interaction contains the compression energy;
                                          ///< false: findStoredEnergy
                                          ///< (core/simulation/sums/stored_energy.hpp) adds it
};

}  // namespace thaw
