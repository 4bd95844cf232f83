// SPDX-License-Identifier: Apache-2.0
// Correction of heat conduction at free surfaces (docs/theory/heat.md): pairs that would lie outside of a
// body are missing in the sums of its outermost particles.
#pragma once
#include <vector>

#include "core/heat/free_surface_sums.hpp"
#include "core/kernels/lattice.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Work data, reused.
struct ConductionWork {
  std::vector<ConductionSums> sums;
};

/// Returns true if conduction is normalised and conductivities are per particle.
bool correctsConduction(const Scene& scene, const Modules& modules);

/// Returns the factor of a particle's conductivity with which its pairs conduct as much as a lattice along
/// the axis of their largest moment, such as along a surface or a rod. 1 inside, at most 2. Its product with
/// the sum of the weights is at most the sum of the lattice, for which the step is stable.
double conductionFactor(const LatticeConduction& lattice, const ConductionSums& sums);

/// Sets Continuum::conductionCorrection of the particles in the lists, except sleeping ones. It is 0 within a
/// spacing of a wall, whose heat is scaled for the plain sum.
void correctConduction(const PairSums& sums, const WallContext& walls, const WallContacts& contacts,
                       ConductionWork& work);

}  // namespace thaw
