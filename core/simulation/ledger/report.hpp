// SPDX-License-Identifier: Apache-2.0
// The ledger summed over all ranks, exactly, with its residuals.
#pragma once
#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct StepTools;

/// Energies (J) of lamps, lasers or heated regions since the start.
struct SourceReport {
  double given = 0, absorbed = 0, reflected = 0;
  double missed() const {
    return given - absorbed - reflected;
  }  ///< energy that met no body, or hit an
     ///< obstacle
};

struct LedgerReport {
  Balance now, initial, entered, left;
  double dissipated = 0, wallWork = 0, heatIn = 0, phaseJump = 0, restartJump = 0;  // J
  Vec3d wallImpulse{}, gravityImpulse{};                                            // N s
  bool hasSources = false;  ///< the scene has lamps, lasers or heated regions; else their energies are 0
  SourceReport lamps, lasers, regions;
  bool hasVapour = false;     ///< the scene has liquids that evaporate
  double evaporated = 0;      ///< kg, also in left.mass
  double vapourHeat = 0;      ///< J, latent heat of the vapour; minus this is in heatIn
  Vec3d impulseInFlight{};    ///< N s, impulse in flight. Contacts have applied it to vertices and particles,
                              ///< and apply it to oriented particles in the next step
  double massResidual = 0;    ///< kg
  Vec3d momentumResidual{};   ///< kg m/s
  double energyResidual = 0;  ///< J, mechanical: kinetic + elastic + potential minus inflow, outflow, work
                              ///< and dissipation
  double heatResidual = 0;    ///< J, change of internal energy minus heat inflow
  double energyScale = 0;     ///< J, largest term of energyResidual
  double energyLargest = 0;   ///< J, largest energyScale of now and of all snapshots since the run began
  double energyRounding = 0;  ///< J, limit below which mechanical energies are only rounding errors of their
                              ///< terms or of the heat that moved
  double heatScale = 0;  ///< J, the larger of the heat that moved and the heat that temperature differences
                         ///< in the scene can move
  double liquidFraction = 0;  ///< liquid fraction of the continuum's mass, without sheets and oriented
                              ///< particles
  std::int64_t particles = 0;
  std::int64_t rows[2] = {0, 0};  ///< number of rows by body type, without the continuum
                                  ///< (core/simulation/world/body_types.hpp)
};

/// Returns true if the energies are so small that relative residuals are meaningless.
inline bool isRounding(const LedgerReport& r) { return r.energyScale < r.energyRounding; }

/// Adds the particles of these rows to a balance.
void addToBalance(const World& world, std::span<const std::uint32_t> rows, ExactBalance& balance);

/// Returns the balance of this rank. Requires: stored energies (core/simulation/sums/stored_energy.hpp).
ExactBalance balanceHere(const World& world);

/// Makes the report; computes stored energies if the last step did not
/// (core/simulation/sums/stored_energy.hpp). Collective.
LedgerReport reportLedger(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
