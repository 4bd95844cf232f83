// Density by continuity, and shifting of particles: what follows from the sums of terms/carried_density.hpp.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Takes from each filling what is too much of the particle itself: then it is 1 on the lattice and grows with compression there as the density
/// does, which at h = 2 dx the plain sum does by .95 only (as Dehnen & Aly 2012 eq. 18 correct it; .95 also on bcc and fcc).
void removeSelfWeight(World& world, double selfWeight);

/// Takes the filling by places (walls included) as how crowded it is, moves on the carried filling by dt (s) and puts it in its place;
/// sets the velocity of shifting. dt 0: only the latter. Books what diffusion takes of the energy of compression.
void carryDensity(World& world, const StepTools& tools, double dt);

}  // namespace thaw
