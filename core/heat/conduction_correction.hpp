// SPDX-License-Identifier: Apache-2.0
// Correction of heat conduction at free surfaces (docs/theory/heat.md): pairs that would lie outside of a
// body are missing in the sums of its outermost particles.
#pragma once
#include <vector>

#include "core/heat/free_surface_sums.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Work data, reused.
struct ConductionWork {
  std::vector<ConductionSums> sums;
};

/// Values of the sums inside of the lattice.
struct LatticeConduction {
  double weight = 0, moment = 0;  ///< moment: along each axis
};
LatticeConduction latticeConduction(const Numerics& numerics);

/// Returns true if pairs conduct heat with the scale of the lattice and records have conductivities.
bool correctsConduction(const Scene& scene, const Modules& modules);

/// Returns the factor of a particle's conductivity with which its pairs conduct as much as a lattice along
/// the direction in which most of them lie: along a surface, a rod. 1 inside, at most 2. The sum of its
/// pairs' weights does not exceed that of the lattice, whose step is stable.
double conductionFactor(const LatticeConduction& lattice, const ConductionSums& sums);

/// Sets Continuum::conductionCorrection of the particles in the lists. It is 0 within a
/// spacing of a wall, whose heat is scaled for the plain sum.
void correctConduction(const PairSums& sums, const Numerics& numerics, const WallContacts& contacts,
                       Continuum& particles, ConductionWork& work);

}  // namespace thaw
