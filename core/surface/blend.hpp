// Solids keep their detail, fluids are smooth (K05 4.5).
#pragma once
#include "core/world.hpp"

namespace thaw {

/// After the iterations of an update: x and the normal go from where the surfel was carried to toward where
/// it settled. The paper's x = (1 - b) x_carried + b x_settled, b the surfel's liquid fraction, takes the
/// share b of every mark in every update; here what is left of a mark is 1 - b for the largest b since the
/// surfel was solid, whatever the number of updates, less as the body strains meanwhile, and only what the
/// motion has added since is followed by b of it in each. Where nothing is known of before (the first update
/// that finds it molten) that is the paper's formula. `detail` is what is left. What has frozen (b = 0) keeps
/// what it has. What is born before the iterations is treated like those around it, but for the faces of
/// cracks (Surfels::loose), which stay where they settled. Does nothing for a surface without a liquid
/// fraction. Needs columns `carried` and `carriedNormal` of displaceSurfels and switches them off. Not
/// collective; surfels have no valid cells afterwards.
void blendSurfels(World& world);

}  // namespace thaw
