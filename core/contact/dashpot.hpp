// SPDX-License-Identifier: Apache-2.0
// Damping ratio of a contact for a coefficient of restitution.
#pragma once

namespace thaw {

/// Returns the damping ratio (1) of a spring and dashpot that never pull, for a coefficient of restitution in
/// [0, 1]. Contact ends at zero force, before the spring's half period (SP07 eq. 13). Smaller coefficients
/// than 0.025 count as 0.025, since the damping would diverge.
double dashpotRatio(double restitution);

}  // namespace thaw
