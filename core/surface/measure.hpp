// What there is of each component: counts, mass, volume, area.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Surface::components of what is there, ascending by label, the same on all ranks: sums are exact, so that
/// they do not depend on how a component is spread. Needs Surfels::area and components that are 1 + the id of
/// one of their particles. The volume is that of enclosed_volume.hpp. Across periodic sides a component is
/// taken in one piece (one_piece.hpp): the domain is cut open where the component leaves the widest gap, and
/// the centroid of the piece is put into the domain. An axis that it goes round (it leaves no gap) is left
/// out of the volume, unless all are: then the volume means nothing; the centroid is there the mean of its
/// particles' places in the domain. What has no surfels has volume and area 0. Only components that are on
/// several ranks send whole exact sums; a spray of drops sends its results. Collective.
void measureComponents(Surface& surface, Reducer& all);

/// Of a label; null if there is no such component.
const SurfaceComponent* findComponent(const Surface& surface, std::uint64_t label);

}  // namespace thaw
