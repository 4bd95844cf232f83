// SPDX-License-Identifier: Apache-2.0
// Balance of the forces by curvature. Over a closed surface they add up to 0 only without errors of the
// curvature: a small drop would push itself.
//
// The surface stress gamma (1 - n n), summed over pairs, conserves momentum, but depends on the arrangement
// of the particles. Its difference to the force by curvature is spread over the neighbours and subtracted.
// So the forces of a small drop have the sum of the stress, 0.
#pragma once
#include "core/flow/curvature/surface_curvature.hpp"

namespace thaw {

/// Balances the forces (N) of owned rows. Overwrites surfaceGradient. Collective.
/// Requires: surfaceGradient and surfaceColour as findFreeSurface leaves them.
void balanceSurface(const CurvatureContext& context, const std::vector<FreeSurfaceElement>& elements,
                    std::vector<Vec3d>& force);

}  // namespace thaw
