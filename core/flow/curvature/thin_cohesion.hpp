// SPDX-License-Identifier: Apache-2.0
// Cohesion of thin liquid: films, threads and drops without a particle inside have no reliable curvature.
//
// Pairs with a particle that is not resolved (FreeSurfaceElement::resolved) attract each other by the
// central force of tension = "pairwise" (core/fluid/laws/cohesion.hpp).
// Its calibration gives a layer of one particle twice the tension, that of its two faces.
#pragma once
#include "core/flow/curvature/surface_curvature.hpp"

namespace thaw {

/// Adds the cohesion of owned rows to `force` (N). Overwrites surfaceGradient. Collective.
/// Requires: one element per owned row.
void addThinCohesion(const CurvatureContext& context, const std::vector<FreeSurfaceElement>& elements,
                     std::vector<Vec3d>& force);

}  // namespace thaw
