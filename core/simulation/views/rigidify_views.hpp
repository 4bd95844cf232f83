// SPDX-License-Identifier: Apache-2.0
// View for the choice of rigid parts of elastic solids.
#pragma once
#include "core/rigid/rigidify/rigidify_view.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

inline RigidifyView rigidifyView(World& w, StepTools& t) {
  return {rigidView(w, t), w.solids, w.bonds, t.elastic, t.wallContacts, t.closePairs, w.clock};
}

}  // namespace thaw
