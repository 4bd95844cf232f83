// SPDX-License-Identifier: Apache-2.0
// Contact impulses of pieces in the next step.
#pragma once
#include <vector>

#include "core/halo/halos.hpp"
#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/contact/solve_contacts.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Contacts of a step with their impulses.
struct SolvedContacts {
  std::vector<FoundContact> contacts;  ///< each on one rank
  std::vector<PieceMotion> after;      ///< motion of each row in the step, impulses included
  ContactResult result;
  double tolerance = 0;  ///< m/s
};

/// Finds the contacts of all pieces at their present positions. Sets impulses and displacements for the next
/// drift, over dt (s), which prevent new overlap. Wakes sleeping pieces that are loaded or touched. Requires:
/// rows of the pieces of owned particles and ghosts. Collective.
SolvedContacts findContactImpulses(const RigidView& view, const Halos& halos, double dt);

/// Records the contacts of the next step, of dt (s), and updates the sleep state of pieces. Collective.
void acceptContacts(const RigidView& view, const SolvedContacts& solved, double dt, Reducer& all);

}  // namespace thaw
