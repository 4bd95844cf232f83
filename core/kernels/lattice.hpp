// What the sums over neighbours are on the cubic lattice of the scene's spacing.
#pragma once
#include "core/fluid/viscous_weight.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Sum of V W over the lattice, the particle itself included: the filling of a full neighbourhood.
double latticeSum(const Numerics& numerics);

/// What the sum for heat conduction makes of the Laplacian of a quadratic field on the lattice; 1 in the
/// limit of many neighbours. With Conduction::Normalised the sum is divided by it: the "moment-normalised
/// Laplacian" of docs/theory/heat.md, for the mean neighbourhood.
double latticeLaplacian(const Numerics& numerics);
/// 1 / latticeLaplacian, or 1 for Conduction::Plain and the paper's heat model.
double conductionScale(const Numerics& numerics);

/// Weight of the pairwise viscosity for the scene's support: such that layers of the lattice that slide over
/// each other feel the scene's viscosity. One more number than the continuum's could make it exact on the
/// lattice at rest, along axes and diagonals; then flow, which does not leave the lattice at rest, is 4 % too
/// fast at h = 2 dx (benchmark poiseuille).
ViscousWeight viscousWeight(const Numerics& numerics);

/// Largest sum of V W that layers of the lattice come through as they slide over each other, along their own
/// axes or their diagonals; at least latticeSum. With the Wendland kernel and h = 2 dx it is .3 % larger, and
/// liquid that fills its vessel cannot flow with less.
double slidingLatticeSum(const Numerics& numerics);

/// Sum of V |dW/dr| r / 3 over the lattice: 1 where the kernel's gradient is exact.
double latticeGradient(const Numerics& numerics);

/// Largest dt nu / h^2 with which an explicit step of the scene's viscous sum is stable: 2 over its largest
/// eigenvalue, over all plane waves on the lattice. h support radius, nu kinematic viscosity.
double stableViscousStep(const Numerics& numerics);

/// Largest dt alpha / h^2 of heat conduction likewise; alpha diffusivity.
double stableHeatStep(const Numerics& numerics);

/// Largest response of the incompressible solver's sums to a plane wave of pressures on the lattice, over
/// their diagonal (1): a Jacobi step of one over it does not overshoot.
double largestPressureResponse(const Numerics& numerics);

/// Largest change of sum V W (1/h) under a plane wave of displacements of amplitude 1 on the lattice.
double largestFillingSlope(const Numerics& numerics);

}  // namespace thaw
