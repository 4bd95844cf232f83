// SPDX-License-Identifier: Apache-2.0
// Contact of oriented particles with the continuum.
#pragma once
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Adds contact forces between oriented particles and the continuum: springs, dashpots and barriers between
/// centres (plan_contact.hpp). Each particle of a pair has half of the energy. Sets OrientedWork::fastest2,
/// including contacts that begin in the next step. dt: s. Requires: forces and ghosts of oriented and
/// continuum particles. Not collective.
void addContinuumContact(const OrientedView& view, double dt);

}  // namespace thaw
