// Free surface of a liquid that carries its density, and particle shifting, which depends on it.
#pragma once
#include "core/particle_sums.hpp"
#include "core/world.hpp"

namespace thaw {

/// Smallest eigenvalue of the moment below which a particle is at the free surface. It is 1 on a lattice, 0.5 in its outermost layer and 0.86 on
/// average where particles are moved by up to a fifth of a spacing.
inline constexpr double surfaceMoment = 0.68;

/// Is the smallest eigenvalue of a symmetric matrix above `least`?
bool eigenvaluesAbove(const Mat3d& m, double least);

/// Sets Continuum::atSurface of owned particles by the moment of their neighbourhood (Marrone et al. 2010). Near walls, whose part of the moment is
/// unknown, and without moments the neighbours' asymmetry along the walls decides.
/// Requires: moment, crowding, gradientSize of this step.
void findFreeSurface(World& w, const StepTools& t);

/// Sets Continuum::smoothing to the velocity (m/s) of particle shifting, along -grad C (Lind et al. 2012).
/// The speed is at most `numerics.shifting` times the speed of sound. Below it follows what makes disorder: strain, and tension (speed of
/// sqrt(|p| / rho)), so that liquid at rest is left alone. Particles at the free surface stay; those beside it do not move towards it (Sun et al.
/// 2017, eq. 20), and none moves along the normal of a wall.
void shiftParticles(World& w, const StepTools& t);

}  // namespace thaw
