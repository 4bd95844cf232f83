// What the sums over neighbours are on the cubic lattice of the scene's spacing.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Sum of V W over the lattice, the particle itself included: the filling of a full neighbourhood.
double latticeSum(const Numerics& numerics);

/// Largest dt nu / h^2 with which an explicit step of the scene's viscous sum is stable: 2 over its largest eigenvalue, over all
/// plane waves on the lattice. h support radius, nu kinematic viscosity.
double stableViscousStep(const Numerics& numerics);

/// Largest dt alpha / h^2 of heat conduction likewise; alpha diffusivity.
double stableHeatStep(const Numerics& numerics);

/// Largest response of the incompressible solver's sums to a plane wave of pressures on the lattice, over their diagonal (1): a
/// Jacobi step of one over it does not overshoot.
double largestPressureResponse(const Numerics& numerics);

}  // namespace thaw
