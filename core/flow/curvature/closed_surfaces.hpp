// SPDX-License-Identifier: Apache-2.0
// Forces on closed surfaces. The surface tension of a free drop or bubble exerts no net force on it. The
// integral of -gamma kappa n + grad_s gamma over a closed surface is 0. Errors of the curvature leave a net
// force, which is subtracted in proportion to the areas of the particles. Momentum is thus conserved.
#pragma once
#include "core/flow/curvature/surface_curvature.hpp"

namespace thaw {

/// Subtracts the mean force per area of each closed surface from the forces (N) of owned rows. A surface that
/// ends at a wall, at a solid, or at a clamped or sleeping particle keeps its forces. Overwrites setLabel.
/// Collective. Requires: surfaceGradient as findFreeSurface leaves it, on owned rows and ghosts.
void balanceClosedSurfaces(const CurvatureContext& context, std::vector<Vec3d>& force);

}  // namespace thaw
