// SPDX-License-Identifier: Apache-2.0
// Rigid pieces in solvers of velocities.
#pragma once
#include <optional>

#include "core/halo/halos.hpp"
#include "core/rigid/piece_joint.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

/// Returns the joint motion of the scene's rigid pieces; empty without rigid pieces.
inline std::optional<PieceJoint> jointOfPieces(World& w, Halos& halos, RigidWork& rigid) {
  std::optional<PieceJoint> joint;
  if (w.modules.rigid) joint.emplace(rigidView(w, rigid), halos.all);
  return joint;
}

}  // namespace thaw
