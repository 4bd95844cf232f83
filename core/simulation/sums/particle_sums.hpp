// SPDX-License-Identifier: Apache-2.0
// The parts of a step that are sums over neighbour pairs.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/sums/pass_rows.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Returns the ghost columns that neighbour sums read, for the active modules.
ColumnList ghostColumns(const Modules& modules, Continuum& particles);

/// Returns input and output of the neighbour sums for this world.
PairSums pairSumsOf(World& world, const PairSumWork& work);

/// Clears all accumulated rates. pairsSet: except those that the pair sums of one liquid (Modules::uniform)
/// assign, which come first.
void clearRates(Continuum& particles, bool pairsSet = false);

/// Sets PairSumWork::inner of the present cells: 1 if sums need no ghosts. owned: number of owned rows.
void markInner(const CellTable& cells, std::size_t owned, const CellHalo& halo,
               std::vector<std::uint8_t>& inner);

/// Gives coincident particles a tiny opposite impulse, with a direction derived from the id
/// (docs/validation/stability.md, row 9). before: Counters::coincidentPairs before the sums. Called at the
/// end of an evaluation; takes effect in the next step.
void separateCoincident(World& world, const PairRecords& records, std::int64_t before);

/// Searches, and adds to Continuum::force the force of a uniform pressure of 1 Pa, -2 V_i sum V_j grad W (N).
/// Requires: ghosts.
void sumUnitPressure(World& world, const std::vector<LiquidMaterial>& liquids, PairSumWork& work);

/// After sumUnitPressure, at the same positions: computes the relative density (without walls), and a force
/// in Continuum::force. Its pressure is 1 Pa times the excess of liquids' relative density above 1. It is
/// -V_i times the gradient (1/m), with respect to the position of i, of half the sum of squared excesses.
/// Collective.
void sumExcessPressure(World& world, CellHalo& halo, const std::vector<LiquidMaterial>& liquids,
                       PairSumWork& work);

/// Packs the records of a pass and searches the neighbours of its rows. elapsed: s, last step.
void searchNeighbours(World& world, StepTools& tools, Part part, double elapsed);

/// Sums the densities of rows.
void sumDensities(World& world, StepTools& tools, const PassRows& rows);
/// The same, for liquids that carry their density over the last step, elapsed (s).
void sumCarriedDensities(World& world, StepTools& tools, const PassRows& rows, double elapsed);

/// Sums pressure, viscosity and conduction of pairs. With incompressible liquid, forces go to
/// Continuum::drag: its pressure is computed at the end of the step.
void sumForces(World& world, StepTools& tools, const PassRows& rows);
/// Adds the pair sums of the scene's terms (ModelPart::sweeps). Requires: sumForces for these rows.
void sumTerms(World& world, StepTools& tools, const PassRows& rows);
/// Adds Continuum::drag to the force. Call it once, after its sums.
void addExplicitForces(Continuum& particles);

/// Adds the pair forces of extensions, with their energies. Requires: ghosts, and the records of this step.
void sumPairForces(World& world, StepTools& tools);
/// Adds Continuum::positionForce to the force. Call it once, after its sums.
void addPositionForces(Continuum& particles);
/// Returns the constants of a pair force in this scene.
PairConstants constantsOf(const Scene& scene, const CellGrid& grid, const PairForceWork& work);

/// Returns true in steps that renew Continuum::viscosityCorrection.
bool viscosityCorrectionDue(const Modules& modules, const Clock& clock);
/// Renews Continuum::viscosityCorrection for the next step. Requires: the records of this step.
void correctViscosity(World& world, const PairSumWork& sums, WallWork& walls);

/// Computes viscous forces of the implicit solver (core/flow/implicit_viscosity/), after all others.
void solveViscosity(World& world, Halos halos, StepTools& tools, const WallContext& walls);

/// Runs the pressure solver (core/flow/incompressible/). dt (s): the step that ends now. Collective.
void solvePressure(World& world, Halos halos, StepTools& tools, double dt);

}  // namespace thaw
