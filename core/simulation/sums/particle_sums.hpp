// SPDX-License-Identifier: Apache-2.0
// The parts of a step that are sums over neighbour pairs.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/sums/pass_rows.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Returns input and output of the neighbour sums for this world.
PairSums pairSumsOf(World& world, const PairSumWork& work);

/// Clears all accumulated rates. pairsSet: excludes rates that the pair sums of one liquid (Modules::uniform)
/// assign, since these sums come first.
void clearRates(Continuum& particles, bool pairsSet = false);

/// Sets PairSumWork::inner of the present cells to 1 if their sums need no ghosts. owned: number of owned
/// rows.
void markInner(const CellTable& cells, std::size_t owned, const CellHalo& halo,
               std::vector<std::uint8_t>& inner);

/// Returns the active columns from which records are packed (RecordContext).
ColumnList recordColumns(Continuum& particles);

/// Packs the records of a pass and searches the neighbours of its rows. elapsed: s, last step.
void searchNeighbours(World& world, StepTools& tools, Part part, double elapsed);

/// Sums pressure, viscosity and conduction of pairs. With incompressible liquid, forces are added to
/// Continuum::drag, since the pressure is computed at the end of the step.
void sumForces(World& world, StepTools& tools, const PassRows& rows);
/// Adds the pair sums of the scene's terms (ModelPart::sweeps). Requires: sumForces for these rows.
void sumTerms(World& world, StepTools& tools, const PassRows& rows);
/// Adds Continuum::drag to the force. Call it once, after its sums.
void addExplicitForces(Continuum& particles);

/// Adds Continuum::positionForce to the force. Call it once, after its sums.
void addPositionForces(Continuum& particles);

}  // namespace thaw
