// SPDX-License-Identifier: Apache-2.0
// Kinematic constraints of position or orientation.
#pragma once
#include "core/oriented/data/oriented.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Constraint index of rows that stay fixed permanently.
inline constexpr std::uint16_t noConstraint = 0xffff;

/// Moves fixed rows to the pose of their constraints at a time (s), dt (s) after the last call. Sets their
/// velocity and spin. Releases rows of constraints that have ended.
void moveConstrained(Oriented& rows, const Scene& scene, double time, double dt);

}  // namespace thaw
