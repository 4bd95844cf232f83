// SPDX-License-Identifier: Apache-2.0
// Stability monitor. In every step it checks values that the time-step reduction provides. At every snapshot
// (snapshot.hpp) it also checks the energy budget and inverted solids.
#pragma once
#include <cstdint>

#include "core/materials/liquid_materials.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/simulation/time/monitor_limits.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Computes the limits. The speed limit is Numerics::watchSpeed times the sum of the expected speed and a
/// tenth of the fastest wave speed. Motion that is driven by released stress is slower than the latter.
MonitorLimits monitorLimits(const Scene& scene, const Modules& modules,
                            const std::vector<LiquidMaterial>& liquids, const StepLimits& materials);

/// Returns the largest relative density of this rank's liquid particles.
double largestRelativeDensity(const Continuum& particles);

/// Checks reduced values after the time-step reduction. limits: s, of all ranks, before Numerics::fixedStep
/// and MonitorState::factor are applied. relativeDensity: largest relative density of all ranks. The result
/// is the same on all ranks.
Failure failureOf(const World& world, const MonitorLimits& bounds, const StepLimits& limits,
                  double relativeDensity);

/// Checks the energy budget at a possible snapshot:
/// - Energy: the unexplained gain since the last snapshot exceeds MonitorLimits::energy times a scale. The
/// scale is the largest of: the ledger's terms at that snapshot, external work so far, kinetic energy of all
/// mass at the expected speed.
/// - Growth: the same since the run began. The scale is the largest ledger term so far. It is at least the
///   kinetic energy at a tenth of the expected speed.
/// - Inverted: the fraction of solid particles with det F <= 0 and without a restoring force. Green strain
/// without volume force has none.
/// Energy losses do not count. They do not make a run unstable, and appear in the ledger's residual.
/// Collective.
Failure checkEnergyBudget(const World& world, const MonitorLimits& bounds, const LedgerReport& budget,
                          Reducer& all);

/// Returns the factor of the next step, one step closer to 2^-backoff.
double nextFactor(const MonitorState& monitor);

/// Accepts the state as a snapshot. The step doubles and the number of counted failures decreases after
/// MonitorState::requiredSnapshots snapshots since the latest failure. The time must also be past
/// MonitorState::passed.
void acceptState(MonitorState& monitor, const Clock& clock, const LedgerReport& budget);

/// Returns true if a failed run may retry with half the step. It may not after Numerics::retries retries, or
/// if the step would be below MonitorLimits::step.
bool mayRetry(const Numerics& numerics, const MonitorState& monitor, const Clock& clock,
              const MonitorLimits& bounds);
/// Returns true if half the step is below MonitorLimits::step.
bool retryTooShort(const MonitorState& monitor, const Clock& clock, const MonitorLimits& bounds);

/// Halves the step after a rollback. failed: monitor state of the failed run; failedAt: its time (s). If the
/// interval between frames is shorter than the step, the interval is halved instead. The failure counts as
/// passed Numerics::retryEvery full steps after failedAt.
void halveStep(MonitorState& monitor, Clock& clock, const Scene& scene, const MonitorState& failed,
               double failedAt);

}  // namespace thaw
