// SPDX-License-Identifier: Apache-2.0
// Rigid pieces break where their strength is exceeded in an impact [MMDJ01]. The stress follows from a static
// elastic solve (elastic_solve.hpp). A piece is cut at its most overloaded particle. The plane passes through
// the most stretched bond there, normal to the principal stress. The parts keep the motion of the piece, and
// contacts are solved again.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Finds the contact impulses of the next step, of dt (s). In scenes with breaking pieces, breaks overloaded
/// pieces and their parts, up to mostCuts times. Has the requirements of findContactImpulses. Collective.
void touchAndBreak(const RigidView& view, const Halos& halos, double dt);

/// Maximum number of successive cuts in a step.
inline constexpr int mostCuts = 6;

}  // namespace thaw
