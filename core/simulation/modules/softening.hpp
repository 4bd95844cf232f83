// SPDX-License-Identifier: Apache-2.0
// Energies of compression and tension, stored or differentiated for the phase changes at the end of a step.
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Stores compression and tension energy in PhaseEnergyWork::ofPairs. Call it after the neighbour sums, and
/// before pair forces of extensions and contacts are added.
void keepPairEnergy(const Continuum& particles, PhaseEnergyWork& work);

/// Computes Continuum::softening of compression and surface energy from Continuum::interaction, and stores
/// the energy of pairwise tension. Call it after the neighbour sums and before contacts are added. Summed
/// compression and surface energy are proportional to the particle's liquid fraction, carried compression is
/// not.
void beginSoftening(World& world, StepTools& tools);

/// Returns whether the energies of pairwise tension and of pair forces of extensions change with the liquid
/// fractions of this rank. The energy of a pair is proportional to both fractions.
bool pairEnergyChanges(const World& world, const TermWork& terms, const PhaseEnergyWork& work);
/// Records the change of these energies at fixed positions in Ledger::phaseJump and Continuum::interaction.
/// It needs another sum over pairs. Requires: liquid fractions of ghosts, and the records of this step.
void recordPairEnergyChange(World& world, StepTools& tools);

}  // namespace thaw
