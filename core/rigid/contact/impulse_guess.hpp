// SPDX-License-Identifier: Apache-2.0
// First guesses of contact impulses. Each particle stores one impulse from step to step.
#pragma once
#include <span>

#include "core/rigid/contact/find_contacts.hpp"

namespace thaw {

/// Sets first guesses: the contacts of a particle with its partner along whose normal the stored impulse acts
/// most share it. If each contact received it, the impulses of wedged pieces would grow from step to step.
void guessImpulses(const Continuum& particles, std::span<FoundContact> contacts);

/// Stores the solved impulses in the particles: the sum over the contacts that share the normal of the
/// contact with the largest impulse. Particles of sleeping pieces keep theirs.
void keepImpulses(std::span<const FoundContact> contacts, const Pieces& pieces, Continuum& particles);

}  // namespace thaw
