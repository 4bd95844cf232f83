// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/contact/body_contact.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// step: s, length of steps; dt: s, step that ends now, or 0.
inline BodyContactView bodyContactView(World& w, BodyContactWork& work, double step, double dt) {
  return {w.scene, w.grid, w.cells, w.solids, w.bonds, w.particles, work, step, dt, w.modules.welding};
}

}  // namespace thaw
