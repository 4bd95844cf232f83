// SPDX-License-Identifier: Apache-2.0
// Energies that only reports, checkpoints, frames and leaving particles need.
#pragma once
#include <cstdint>
#include <span>

#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Computes Solids::energy, Solids::deformation and the compression energy in Continuum::interaction, unless
/// the last evaluation computed these. Call it before a checkpoint, a snapshot or a frame; the ledger's
/// report calls it itself. Results have the same bits no matter when and how often it is called.
void findStoredEnergy(World& world, const StepTools& tools);
/// The same for the particles in these rows, which are about to leave.
void findStoredEnergy(World& world, const StepTools& tools, std::span<const std::uint32_t> rows);

}  // namespace thaw
