// SPDX-License-Identifier: Apache-2.0
// Correction of heat conduction at free surfaces (docs/theory/heat.md). The sums of the outermost particles
// lack pairs outside of the body.
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

/// Returns the factor (1) of a particle's conductivity: 1 inside, at most 2. With it, pairs conduct as much
/// as a lattice along the axis of their largest moment, for example along a surface or a rod. The factor
/// times the sum of weights is at most the lattice's sum, for which the step is stable.
double conductionFactor(const LatticeConduction& lattice, const ConductionSums& sums);

/// Sets Continuum::conductionCorrection of the awake particles in the lists. It is 0 within a spacing of a
/// wall, because wall heat is scaled for the uncorrected sum.
void correctConduction(const PairSums& sums, const WallContext& walls, const WallContacts& contacts,
                       ConductionWork& work);

}  // namespace thaw
