// How strongly a contact must be damped for a given coefficient of restitution.
#pragma once

namespace thaw {

/// Damping ratio (1) of a spring and dashpot that push but never pull, for a coefficient of restitution in
/// [0, 1]: contact ends when the force is zero, earlier than the spring's half period (Schwager & Poeschel
/// 2007, "Coefficient of restitution and linear-dashpot model revisited", eq. 13). Restitutions below 0.025
/// are taken as that: their damping grows without bound.
double dashpotRatio(double restitution);

}  // namespace thaw
