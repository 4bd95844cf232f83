// The facets between a surfel and its neighbours: what the volume in a surface is measured by.
#pragma once
#include <cstdint>
#include <span>

#include "core/surface/surfels.hpp"

namespace thaw {

/// Surfels::facets and bulge of surfel i: its Voronoi share of the facets around it, the triangles (i, a, b)
/// over each two that follow each other in `ring`, the neighbours that its cell borders on, in turn round its
/// normal. Together these facets are a closed mesh through the surfels, whose vector areas add up to zero:
/// sum x.facets / 3 is its volume, also of a film, of which sum x.n A with the surfels' own normals is off by
/// half. Voronoi shares (Meyer et al. 2003) do not depend on which diagonal of four surfels in a circle each
/// of them takes. Over a facet the surface bulges: by area/24 sum (n_b - n_a).(x_b - x_a) over its three
/// sides to second order; what normals that turn farther add to that is fitted to spheres of 24 to 100
/// surfels, whose volume is then right to .1 %. Two planes that meet at an edge bulge by twice that.
void measureFan(Surfels& surfels, std::size_t i, std::span<const std::uint32_t> ring);

}  // namespace thaw
