// SPDX-License-Identifier: Apache-2.0
// Damping ratio of a contact for a coefficient of restitution.
#pragma once

namespace thaw {

/// Returns the damping ratio (1) of a spring and dashpot that never pull, for a coefficient of restitution in
/// [0, 1]. Contact ends at zero force, before the spring's half period (SP07 eq. 13). Values below 0.025 are
/// raised to it, since the damping would diverge.
double dashpotRatio(double restitution);

}  // namespace thaw
