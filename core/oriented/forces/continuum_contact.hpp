// SPDX-License-Identifier: Apache-2.0
// Contact of oriented particles with the continuum.
#pragma once
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Adds contact forces of oriented particles and the continuum: springs, dashpots and barriers between
/// centres (plan_contact.hpp), with half of the energy at each end. Sets OrientedWork::fastest2, including
/// contacts that begin in the next step. Requires: forces and ghosts of both. Not collective.
void addContinuumContact(const OrientedView& view, double dt);

}  // namespace thaw
