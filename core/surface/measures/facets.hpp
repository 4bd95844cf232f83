// SPDX-License-Identifier: Apache-2.0
// Facets between a surfel and its neighbours, for the enclosed volume.
#pragma once
#include <cstdint>
#include <span>

#include "core/surface/data/surfels.hpp"

namespace thaw {

/// Computes Surfels::facets and bulge of surfel i: its Voronoi share of the surrounding facets. Facets are
/// the triangles (i, a, b) with consecutive neighbours a, b in `ring`. `ring` contains the neighbours at the
/// borders of the surfel's cell, ordered around its normal. Together, facets form a closed mesh. Its vector
/// areas sum to zero, and its volume is sum x . facets / 3. This is also valid for films, for which sum x . n
/// A with the surfels' normals is wrong by half. Voronoi shares (MDSB03) do not depend on the diagonal that
/// each of four cocircular surfels uses. To second order, the surface bulges over a facet by area/24 sum (n_b
/// - n_a).(x_b - x_a) over its sides. The term for larger angles is fitted to spheres of 24 to 100 surfels:
/// their volume is exact to 0.1 %. Two planes that meet at an edge bulge by twice the second-order term.
void measureFan(Surfels& surfels, std::size_t i, std::span<const std::uint32_t> ring);

}  // namespace thaw
