// SPDX-License-Identifier: Apache-2.0
// Normal velocities after impacts that spread through the contacts of an island.
#pragma once
#include <vector>

#include "core/rigid/contact/contact_islands.hpp"
#include "core/rigid/contact/solve_contacts.hpp"

namespace thaw {

struct ImpactTargets {
  std::vector<double> speed;    ///< m/s, smallest normal velocity of each contact after the step
  std::vector<double> impulse;  ///< N s, normal impulses of successive impacts; empty: all impacts are
                                ///< simultaneous
};

/// Returns the targets of Newton's law: all contacts rebound at once.
ImpactTargets simultaneousImpacts(const ContactIsland& island, const ContactSettings& settings);

/// Returns the targets of successive impacts [SKV12]. Approaching contacts rebound together, without
/// friction. Then the contacts that approach as a result rebound, until none approach. The targets
/// are those of Newton's law without restitution, if impacts cause no further impacts, or if the sequence
/// does not end.
ImpactTargets successiveImpacts(const ContactIsland& island, const ContactSettings& settings);

}  // namespace thaw
