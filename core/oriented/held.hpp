// Anchors: what holds particles in place or in orientation, and moves them.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Number of the anchor of what is held for ever where it is.
inline constexpr std::uint16_t noAnchor = 0xffff;

/// Puts what is held where its anchor has it at a time (s), dt after the last; its velocity and spin are what
/// led there. Lets go what is over.
void moveHeld(World& world, double time, double dt);

}  // namespace thaw
