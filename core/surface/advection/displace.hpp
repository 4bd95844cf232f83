// SPDX-License-Identifier: Apache-2.0
// Moves the surface with the particles (K05 4.2.1).
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

struct SurfaceTools;

/// Computes the gradient of the particles' displacement (1) by moving least squares at the previous
/// positions. Neighbours are within the support radius, of the same component, and not new. If they lie in a
/// plane or a line, the gradient is completed by a rotation (core/solid/elasticity/moment.hpp). Requires:
/// particles on the ranks of their cells at their previous positions; they have ghosts afterwards.
/// Collective.
void findDisplacementGradients(const CellGrid& grid, Surface& surface, SurfaceHalos halos,
                               SurfaceTools& tools);

/// Moves surfels with the particles: x += sum w (u_j + grad u_j (x - x_j)). w are the normalised weights (1 -
/// (r/h_ps)^2)^3 of the component's particles within h_ps, reduced for particles with a larger liquid
/// fraction (leastMotionWeight). The exact gradient of this sum rotates tangents, and the normal follows from
/// the tangents. Liquid surfels use the mean gradient, because the iterations determine their normals. The
/// result is exact for affine motion. A surfel without particles gets the mean displacement of neighbouring
/// surfels.
/// Without neighbours, it is deleted and counted (stability row 15). Requires: gradients; surfels on the
/// ranks of their cells. Afterwards surfels have no ghosts and no valid cells (placeRows). With a liquid
/// fraction, `carried` and `carriedNormal` are set. Collective.
void displaceSurfels(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Returns the interpolated displacement (m) of each owned surfel, as in displaceSurfels, without moving
/// surfels. It is zero without particles. Requires: gradients; surfels on the ranks of their cells. Drops
/// ghosts of surfels.
std::vector<Vec3d> interpolatedDisplacements(Surface& surface, SurfaceTools& tools);

}  // namespace thaw
