// SPDX-License-Identifier: Apache-2.0
// Density by continuity, and particle shifting. The density sums advance the carried densities
// (terms/carried_density.hpp, terms/carry.hpp). This file prepares and completes these sums.
#pragma once
#include <cstdint>
#include <vector>

#include "core/flow/density/carry_work.hpp"
#include "core/fluid/pair_sums/carry.hpp"
#include "core/ledger/counters.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"
#include "core/walls/tables.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// The data of a step that carried densities read and change.
struct CarryContext {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  Continuum& particles;
  const NeighbourLists& neighbours;
  const Walls& walls;
  std::vector<float>& initialSummedDensity;  ///< 1, summed at the start, by owned row
  const Clock& clock;
  Counters& counters;
  const std::vector<LiquidMaterial>& liquids;
  const WallTables& wallTables;
  double inverseLatticeSum;  ///< factor that turns sums over V W into relative densities
  CarryWork& carry;
  WallContacts& wallContacts;
  const std::vector<std::uint8_t>& steady;  ///< SleepWork::steady
  double dt;  ///< s, last step; 0 at the start, when only the free surface, shifting and gradient correction
              ///< are computed
};

/// Prepares the density sums of a step. Requires: wall contacts.
void beginCarry(const CarryContext& context);

/// Returns the input and output of the density sums. The result refers to data of the context.
CarryStep carryStepOf(const CarryContext& context);

/// Ends the step of carried densities after the density sums. Resets particles without liquid nearby, and
/// stores the summed densities that later checks need.
void finishCarry(const CarryContext& context);

/// Sets shifting velocities with summed densities. Inside the liquid they point down the concentration
/// gradient. At a free surface, where the gradient is along the normal, they are zero.
void shiftInside(const CarryContext& context);

}  // namespace thaw
