// SPDX-License-Identifier: Apache-2.0
// Impulse and work of constraints, for the ledger.
#pragma once
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// State before a step of dt (s), for recordConstraintWork: call stateBefore, the step, moveConstrained,
/// recordConstraintWork.
struct StateBefore {
  double dt;
  std::vector<Vec3d> velocity, place, spin;
  std::vector<Quat> turn;
  std::vector<std::uint8_t> flags;  ///< flags before the step, since a constraint may release rows at its end
};
StateBefore stateBefore(const Oriented& rows, double dt);

/// Records impulse and work of the constraints in the ledger: the change of momentum and energy, less those
/// of all other forces and torques (OrientedWork::acting, actingTorque). Requires: the forces of the step,
/// with Oriented::external scaled by `weight` (see stepOriented).
void recordConstraintWork(const OrientedView& view, const StateBefore& before, double weight);

}  // namespace thaw
