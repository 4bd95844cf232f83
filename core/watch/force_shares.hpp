// What acts on one particle, term by term, for the message of a run that fails.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Sizes in N. pressure: of the liquid around it, with surface tension where the scene has that (both depend
/// on places alone); of the incompressible solver: the impulse that it prepared, over the step. viscosity:
/// all that resists in the liquid. contact: of solids.
struct ForceShares {
  double elastic = 0, pressure = 0, viscosity = 0, contact = 0, walls = 0, weight = 0;
  bool atWall = false;  ///< closer than a spacing
};

/// Of an owned particle after a step that failed. Sums it all once more, with one term after the other;
/// forces, velocities and books are put back, other sums are not: what follows must go back to a good state
/// or end.
ForceShares forceShares(World& world, StepTools& tools, std::size_t row);

}  // namespace thaw
