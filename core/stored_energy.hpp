// Energies that reports, checkpoints, frames and leavers ask for, and no step.
#pragma once
#include <cstdint>
#include <span>

#include "core/step.hpp"

namespace thaw {

/// What the last evaluation has not found of Solids::energy, Solids::deformation and, of the energy of
/// compression, Continuum::interaction. Before a checkpoint, a good state or a frame; the ledger's report
/// sees to it by itself. The same bits whenever and however often it is asked for.
void findStoredEnergy(World& world, const StepTools& tools);
/// The same for the particles in these rows, which are about to leave.
void findStoredEnergy(World& world, const StepTools& tools, std::span<const std::uint32_t> rows);

}  // namespace thaw
