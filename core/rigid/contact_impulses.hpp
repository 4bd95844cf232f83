// SPDX-License-Identifier: Apache-2.0
// Impulses of the contacts of pieces in the next step.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Finds the contacts of all pieces at their present positions. Sets the impulses and displacements with
/// which the next drift, over dt (s), leaves them without new overlap. Requires: rows of the pieces of owned
/// particles and ghosts. Collective.
void findContactImpulses(const RigidView& view, const Halos& halos, double dt);

}  // namespace thaw
