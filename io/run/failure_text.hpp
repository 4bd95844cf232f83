// SPDX-License-Identifier: Apache-2.0
// Texts of failures that the stability monitor finds.
#pragma once
#include <string>

#include "core/simulation/monitor/failing_particle.hpp"
#include "io/run/run_state.hpp"

namespace thaw {

/// Returns "a speed of 32.3 m/s exceeds the limit of 30 m/s (...): particle 17 of body 'cube' at (x, y, z) m
/// has ..., forces: ..." on the rank that owns the suspect. Sums the forces again (force_terms.hpp).
std::string failureText(World& world, StepTools& tools, const StepOutcome& failed,
                        const FailingParticle& suspect);

/// Returns the failed check and its bound, without a particle.
std::string failedCheck(const World& world, const StepTools& tools, const StepOutcome& failed);

/// Returns "(x, y, z)" with four digits each.
std::string shortVectorText(const Vec3d& v);

/// Returns on all ranks the text of the one rank where it is not empty. Collective.
std::string broadcastFromOwner(const Communicator& comm, const std::string& text);

}  // namespace thaw
