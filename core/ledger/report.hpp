// The ledger as it is printed: sums over all ranks, exact, and what no term explains.
#pragma once
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

struct LedgerReport {
  Balance now, initial, entered, left;
  double dissipated = 0, wallWork = 0, heatIn = 0, phaseJump = 0, restartJump = 0;  // J
  Vec3d wallImpulse{}, gravityImpulse{};                                            // N s
  Vec3d underWay{};  ///< N s, that contacts have given to vertices and particles, and give to the oriented
                     ///< ones in the next step
  double massResidual = 0;    ///< kg
  Vec3d momentumResidual{};   ///< kg m/s
  double energyResidual = 0;  ///< J, mechanical: kinetic + elastic + potential against what entered, left,
                              ///< was done and dissipated
  double heatResidual = 0;    ///< J, internal against heat that came in
  double energyScale = 0;     ///< J, largest of the terms that went into energyResidual
  double energyLargest = 0;   ///< J, largest energyScale of now and of all good states since the run began
  double energyRounding = 0;  ///< J, below which mechanical energies do not matter: rounding of what they are
                              ///< sums of, or of the heat that has moved
  double heatScale = 0;  ///< J, largest of the heat that has moved and of what differences of temperature in
                         ///< the scene can move
  double liquidFraction = 0;  ///< of the continuum's mass: sheets and oriented particles are neither liquid
                              ///< nor solid
  std::int64_t particles = 0;
  std::int64_t rows[2] = {0, 0};  ///< of the further kinds (core/kinds/kinds.hpp)
};

/// Is this so little energy that a share of it means nothing?
inline bool isRounding(const LedgerReport& r) { return r.energyScale < r.energyRounding; }

/// Adds the particles of rows to a balance.
void addToBalance(const World& world, std::span<const std::uint32_t> rows, ExactBalance& balance);

/// Of all that this rank owns. Needs stored energies (core/stored_energy.hpp).
ExactBalance balanceHere(const World& world);

/// Finds stored energies where the last step did not (core/stored_energy.hpp). Collective.
LedgerReport reportLedger(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
