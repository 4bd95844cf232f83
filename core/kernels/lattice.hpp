// SPDX-License-Identifier: Apache-2.0
// Neighbour sums on the cubic lattice of the scene's spacing. They normalise other sums and give stability
// limits.
#pragma once
#include "core/kernels/viscous_weight.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Sum of V W over the lattice, self included: the value at rest density.
double latticeSum(const Numerics& numerics);

/// Sums of conduction over the lattice.
struct LatticeConduction {
  double weight = 0;  ///< sum of V lap W; lengths in support radii
  double moment = 0;  ///< weights times the square of a coordinate
};
LatticeConduction latticeConduction(const Numerics& numerics);

/// Factor by which the conduction sum scales the Laplacian of a quadratic field on the lattice. It is 1 in
/// the limit of many neighbours. Conduction::Normalised divides by it: the "moment-normalised Laplacian" of
/// docs/theory/heat.md for the mean neighbourhood.
double latticeLaplacian(const Numerics& numerics);
/// 1 / latticeLaplacian, or 1 for Conduction::Plain and the paper's heat model.
double conductionScale(const Numerics& numerics);

/// Weight of the pairwise viscosity for the scene's support, such that sliding layers of the lattice have the
/// scene's viscosity. The weight is not fitted to the lattice at rest, since particles leave that lattice as
/// they flow. The flow would be 4 % too fast at h = 2 dx (benchmark poiseuille).
ViscousWeight viscousWeight(const Numerics& numerics);

/// Largest sum of V W while layers of the lattice slide along their axes or diagonals; at least latticeSum.
/// It is 0.3 % larger for the Wendland kernel at h = 2 dx. Liquid that fills a vessel needs this value to
/// flow.
double slidingLatticeSum(const Numerics& numerics);

/// Sum of V |dW/dr| r / 3 over the lattice: 1 for an exact kernel gradient.
double latticeGradient(const Numerics& numerics);

/// Largest stable dt nu / h^2 of an explicit step of the viscous sum: 2 over its largest eigenvalue over all
/// plane waves on the lattice. h support radius, nu kinematic viscosity.
double stableViscousStep(const Numerics& numerics);

/// Largest stable dt alpha / h^2 of heat conduction; alpha diffusivity.
double stableHeatStep(const Numerics& numerics);

/// Largest response of the incompressible solver's sums to a plane wave of pressures on the lattice, divided
/// by the sums' diagonal (1). A Jacobi step of its inverse does not overshoot.
double largestPressureResponse(const Numerics& numerics);

/// Largest change of sum V W (1/h) under a plane wave of unit displacements on the lattice.
double largestRelativeDensityGradient(const Numerics& numerics);

}  // namespace thaw
