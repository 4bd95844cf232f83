// SPDX-License-Identifier: Apache-2.0
// Anchors: kinematic constraints of position or orientation.
#pragma once
#include "core/oriented/data/oriented.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Anchor index of rows that stay fixed in place forever.
inline constexpr std::uint16_t noAnchor = 0xffff;

/// Moves fixed rows to where their anchors are at a time (s), dt after the last call, and sets their velocity
/// and spin. Releases rows of anchors that have ended.
void moveAnchored(Oriented& rows, const Scene& scene, double time, double dt);

}  // namespace thaw
