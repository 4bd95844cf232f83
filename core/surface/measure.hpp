// What there is of each component: counts, mass, volume, area.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Surface::components of what is there, ascending by label, the same on all ranks: sums are exact, so that they do not depend on how a
/// component is spread. Needs Surfels::area and components that are 1 + the id of one of their particles.
/// The enclosed volume is sum_a (x_a - c_a) n_a A over the axes, divided by their number (divergence theorem), c the centroid. Across
/// periodic sides places are taken the shortest way from the particle that names the component; an axis along which the component reaches
/// farther than 0.4 periods from it is left out, unless all are. What has no surfels has volume and area 0.
/// Only components that are on several ranks send whole exact sums; a spray of drops sends its results. Collective.
void measureComponents(Surface& surface, Reducer& all);

/// Of a label; null if there is no such component.
const SurfaceComponent* findComponent(const Surface& surface, std::uint64_t label);

}  // namespace thaw
