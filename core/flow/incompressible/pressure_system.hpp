// SPDX-License-Identifier: Apache-2.0
// The matrix of the pressure problem as two products: one from pressures to velocities, and one from
// velocities to density rates.
#pragma once
#include <vector>

#include "core/flow/incompressible/pressure_work.hpp"
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/halo/halos.hpp"
#include "core/ledger/counters.hpp"
#include "core/ledger/ledger.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/joint_motion.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"
#include "core/time/phase_times.hpp"
#include "core/walls/tables.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Context of the products and of the solver.
struct PressureSystem {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  Continuum& particles;
  const NeighbourLists& neighbours;
  const Walls& walls;
  const Clock& clock;
  Ledger& ledger;
  Counters& counters;
  PressureIterations& pressureIterations;
  Halos halos;
  PairSums sums;  ///< input and output of the sums of this step
  const PairKernels& kernels;
  const std::vector<LiquidMaterial>& liquids;
  PairRecords& records;
  const WallTables& wallTables;
  double inverseLatticeSum;  ///< factor that turns sums over V W into relative densities
  const WallContacts& wallContacts;
  PressureWork& pressure;
  PhaseTimes& times;
  JointMotion* joint = nullptr;  ///< rigid pieces; null: all particles move on their own
};

/// Computes PressureWork::walls, fraction and response for the current positions.
void prepareSystem(const PressureSystem& system);

/// Computes PressureWork::impulse (N s) from Continuum::trialPressure, and trialVelocity = start + impulse /
/// m. Clamped and driven particles keep their velocities. Collective.
void applyPressures(const PressureSystem& system);

/// Computes PressureWork::rate (1/s) of the relative density for trialVelocity. Collective.
void relativeDensityRate(const PressureSystem& system);

}  // namespace thaw
