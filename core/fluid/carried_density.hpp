// Density by continuity, and shifting of particles: what follows from the sums of terms/carried_density.hpp.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Takes the filling by places (walls included) as how crowded it is, moves on the carried filling by dt (s)
/// and puts it in its place; sets the velocity of shifting. dt 0: only the latter. Books what diffusion takes
/// of the energy of compression, and counts the particles that are much more crowded than the density says
/// that they carry.
void carryDensity(World& world, const StepTools& tools, double dt);

}  // namespace thaw
