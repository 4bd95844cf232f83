// SPDX-License-Identifier: Apache-2.0
// Impulse and work of constraints, for the ledger.
#pragma once
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// State (SI) before a step of dt (s), for recordConstraintWork. Order of calls: stateBefore, the step,
/// moveConstrained, recordConstraintWork.
struct StateBefore {
  double dt;
  std::vector<Vec3d> velocity, place, spin;
  std::vector<Quat> turn;
  std::vector<std::uint8_t> flags;  ///< flags before the step, since a constraint may release rows at its end
};
StateBefore stateBefore(const Oriented& rows, double dt);

/// Records impulse and work of the constraints in the ledger. They are the changes of momentum and energy,
/// minus impulse and work of all other forces and torques (OrientedWork::acting, actingTorque). Requires: the
/// forces of the step, with Oriented::external scaled by `weight` (see stepOriented).
void recordConstraintWork(const OrientedView& view, const StateBefore& before, double weight);

}  // namespace thaw
