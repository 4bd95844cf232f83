// SPDX-License-Identifier: Apache-2.0
// Constraints: kinematic constraints of position or orientation.
#pragma once
#include "core/oriented/data/oriented.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Constraint index of rows that stay fixed in place forever.
inline constexpr std::uint16_t noConstraint = 0xffff;

/// Moves fixed rows to where their constraints are at a time (s), dt after the last call, and sets their
/// velocity and spin. Releases rows of constraints that have ended.
void moveConstrained(Oriented& rows, const Scene& scene, double time, double dt);

}  // namespace thaw
