// SPDX-License-Identifier: Apache-2.0
// Velocities of surfels, for frames.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Returns the velocity (m/s) of each owned surfel: the interpolation of displaceSurfels, with the particles'
/// velocities in place of their displacements. It is exact for affine velocity fields. It is zero for a
/// surfel without particles of its component within the support radius. Requires: an update at the current
/// positions; no particle copies. Sorts the surfels by (cell, id). Collective.
std::vector<Vec3d> surfelVelocities(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
