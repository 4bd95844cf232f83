// SPDX-License-Identifier: Apache-2.0
// View for the choice of rigid parts of elastic solids.
#pragma once
#include "core/rigid/rigidify/rigidify_view.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

inline RigidifyView rigidifyView(World& w, StepTools& t) {
  return {rigidView(w, t.rigid), w.solids, w.bonds, t.solid.elastic, t.walls.contacts,
          t.contact.closePairs,  w.clock};
}

}  // namespace thaw
