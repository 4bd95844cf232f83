// The ledger as it is printed: sums over all ranks, exact, and what no term explains.
#pragma once
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

struct LedgerReport {
  Balance now, initial, entered, left;
  double dissipated = 0, wallWork = 0, heatIn = 0, phaseJump = 0;  // J
  Vec3d wallImpulse{}, gravityImpulse{};                          // N s
  double massResidual = 0;      ///< kg
  Vec3d momentumResidual{};     ///< kg m/s
  double energyResidual = 0;    ///< J, mechanical: kinetic + elastic + potential against what entered, left, was done and dissipated
  double heatResidual = 0;      ///< J, internal against heat that came in
  double energyScale = 0;       ///< J, largest of the terms that went into energyResidual
  double liquidFraction = 0;    ///< of all mass
  std::int64_t particles = 0;
  std::int64_t rows[2] = {0, 0};  ///< of the further kinds (core/kinds/kinds.hpp)
};

/// Adds the particles of rows to a balance.
void addToBalance(const World& world, std::span<const std::uint32_t> rows, ExactBalance& balance);

/// Finds the elastic energy where the last step did not (core/solid_step.hpp). Collective.
LedgerReport reportLedger(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
