// SPDX-License-Identifier: Apache-2.0
// Normal velocities after impacts that spread through the contacts of an island.
#pragma once
#include <vector>

#include "core/rigid/contact/contact_islands.hpp"
#include "core/rigid/contact/solve_contacts.hpp"

namespace thaw {

struct ImpactTargets {
  std::vector<double> speed;    ///< m/s, least normal velocity of each contact after the step
  std::vector<double> impulse;  ///< N s, normal impulses of impacts that caused others; empty: none did
};

/// Returns the targets of Newton's law, where all contacts rebound at once.
ImpactTargets simultaneousImpacts(const ContactIsland& island, const ContactSettings& settings);

/// Returns the targets where impacts follow each other [SKV12]: contacts that approach rebound together
/// without friction, then those that approach as a result, until none does. Without restitution, where
/// impacts cause no others, or where they do not end, the targets are those of Newton's law.
ImpactTargets successiveImpacts(const ContactIsland& island, const ContactSettings& settings);

}  // namespace thaw
