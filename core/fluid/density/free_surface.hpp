// SPDX-License-Identifier: Apache-2.0
// Free surface of a liquid that carries its density, and particle shifting, which depends on it.
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Smallest eigenvalue of the moment below which a particle is at the free surface. It is 1 on a lattice, 0.5
/// in its outermost layer and 0.86 on average where particles are moved by up to a fifth of a spacing.
inline constexpr double surfaceMoment = 0.68;

/// True if all eigenvalues of a symmetric matrix exceed `least` (Sylvester's criterion).
template<class T> bool eigenvaluesAbove(const Sym3<T>& m, T least) {
  const T a = m.xx - least, b = m.yy - least, c = m.zz - least;
  return a > 0 && a * b - m.xy * m.xy > 0 &&
         a * (b * c - m.yz * m.yz) - m.xy * (m.xy * c - m.yz * m.xz) + m.xz * (m.xy * m.yz - b * m.xz) > 0;
}

/// True if a neighbour was at the free surface in the last step.
bool besideSurface(const Continuum& particles, std::size_t row);

/// Sets Continuum::atSurface of owned particles by the moment of their neighbourhood (Marrone et al. 2010).
/// Near walls, whose part of the moment is unknown, and without moments the neighbours' asymmetry along the
/// walls decides. Requires: moment, concentrationGradient, gradientSize of this step.
void findFreeSurface(World& w, const StepTools& t);

/// Velocity (m/s) of particle shifting, along -grad C (Lind et al. 2012).
/// The speed is at most `numerics.shifting` times the speed of sound. Below it follows what makes disorder:
/// strain, and tension (speed of sqrt(|p| / rho)), so that liquid at rest is left alone. Particles at the
/// free surface stay; those beside it do not move towards it (Sun et al. 2017, eq. 20), particles beside a
/// solid are shifted only along it. Requires: the free surface and the flow of this step.
Vec3d shiftOf(const World& w, const StepTools& t, std::size_t row);

/// Removes components along the normals of adjacent walls from Continuum::smoothing.
void shiftAlongWalls(World& w, const StepTools& t);

}  // namespace thaw
