// SPDX-License-Identifier: Apache-2.0
// Parts of the library as extensions, to compare both.
#pragma once
#include "core/terms/extensions.hpp"

namespace thaw::test {

/// The pairwise surface tension, with the key `tension`: "copy_of_tension".
Extension copyOfTension();
/// The Neo-Hookean law, in double precision ("copy") and with the precision of the library ("single_copy").
Extension copyOfNeoHookean();
Extension singleCopyOfNeoHookean();
/// A sphere, with the key `size`: "ball".
Extension copyOfBall();
/// Buoyancy of a liquid with the key `expansion`, which has its density at `from`: "copy_of_buoyancy".
Extension copyOfBuoyancy();
/// A heated region around the origin with the keys `power` and `size`: "copy_of_region".
Extension copyOfRegion();

}  // namespace thaw::test
