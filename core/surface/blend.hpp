// Solids keep their detail, fluids are smooth (K05 4.5).
#pragma once
#include "core/world.hpp"

namespace thaw {

/// After the iterations of an update: x = (1 - b) x_carried + b x_settled with b the surfel's liquid fraction, the normal likewise. Where that
/// is beside where the surfel was carried to, by more than settings.stop of its radius, its detail fades by 1 - b. Surfels born in this update
/// stay where they are. Does nothing for a surface without a liquid fraction. Needs columns `carried` and `carriedNormal` of displaceSurfels
/// and switches them off. Not collective; surfels have no valid cells afterwards.
void blendSurfels(World& world);

}  // namespace thaw
