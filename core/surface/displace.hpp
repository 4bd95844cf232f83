// The surface is carried along with the particles (K05 4.2.1).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Gradient of the particles' displacement (1) by moving least squares over the neighbours in the support
/// radius at the old places, of the same component, fresh ones left out; where they lie in a plane or a line,
/// the rest is completed as a rotation (core/solid/moment.hpp). Needs particles on the ranks of their cells
/// at their old places; they have ghosts afterwards. Collective.
void findDisplacementGradients(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Carries surfels along: x += sum w (u_j + grad u_j (x - x_j)), w the normalised weights (1 - (r/h_ps)^2)^3
/// of the particles of the surfel's component within h_ps, less for those that are more molten than it
/// (leastCarry); tangents by the exact gradient of that sum, the normal from them (liquid ones by the mean of
/// the gradients: their normals come from the iterations). Exact for affine motion. A surfel without
/// particles takes the mean displacement of the surfels around that have some; without those it is deleted
/// and counted (B15). Needs gradients, and surfels on the ranks of their cells; they have no ghosts and no
/// valid cells afterwards (placeRows). Where the surface is of use to the blend, their `carried` and
/// `carriedNormal` are set. Collective.
void displaceSurfels(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
