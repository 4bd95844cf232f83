// SPDX-License-Identifier: Apache-2.0
// Normal velocities after impacts that spread through the contacts of an island.
#pragma once
#include <vector>

#include "core/rigid/contact/contact_islands.hpp"
#include "core/rigid/contact/solve_contacts.hpp"

namespace thaw {

struct ImpactTargets {
  std::vector<double> speed;    ///< m/s, least normal velocity of each contact after the step
  bool spread = false;          ///< impacts caused others
  std::vector<double> impulse;  ///< N s, normal impulses of those impacts; empty if none did
};

/// Returns the targets of Newton's law, where all contacts rebound at once.
ImpactTargets simultaneousImpacts(const ContactIsland& island, const ContactSettings& settings);

/// Returns the targets where impacts follow each other [SKV12]: contacts that approach rebound together
/// without friction, then those that approach as a result, until none does. Without restitution, where
/// impacts cause no others, or where they do not end, the targets are those of Newton's law.
ImpactTargets successiveImpacts(const ContactIsland& island, const ContactSettings& settings);

/// Returns the velocity (m/s) of the first side of a contact relative to the second one.
Vec3d relativeVelocity(const RigidContact& contact, std::span<const PieceMotion> pieces);

}  // namespace thaw
