// SPDX-License-Identifier: Apache-2.0
// Rolling friction: a moment between two pieces in contact that opposes their relative spin. It is at most an
// arm times the normal force, as if the normal force acted at this distance from the contact point.
#pragma once
#include <cstdint>

#include "core/rigid/contact/rigid_contact.hpp"

namespace thaw {

/// Rolling friction of a contact in the solver.
struct Rolling {
  std::uint32_t contact = 0;
  double arm = 0;       ///< m
  Vec3d offset{};       ///< rad/s, relative spin without impulses
  Vec3d impulse{};      ///< N m s
  Sym3d inverse{};      ///< kg m^2, inverse of the response of the relative spin
  double stiffest = 0;  ///< 1/(kg m^2), largest eigenvalue of the response; 0: no row can turn
  double radius = 0;    ///< m, larger distance of the contact from the two centres; converts spins to
                        ///< velocities
  Vec3d before{};       ///< N m s, impulse at the start of the sweep
  Vec3d other{};        ///< N m s, search direction, or impulse after the last sweep
};

/// Returns the rolling friction of a contact between rows with these motions. b: null for an obstacle. The
/// contact gives the first guess of the impulse.
Rolling rollingOf(const RigidContact& contact, const PieceMotion& a, const PieceMotion* b);

/// Limits the impulse to the arm times normalImpulse (N s).
void limitRolling(Rolling& rolling, double normalImpulse);

/// Solves the rolling friction for the present change of the relative spin (rad/s). Returns the change of the
/// impulse (N m s).
Vec3d relaxRolling(Rolling& rolling, const Vec3d& spin, double normalImpulse);

}  // namespace thaw
