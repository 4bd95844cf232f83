// The facets between a surfel and its neighbours: what the volume in a surface is measured by.
#pragma once
#include <cstdint>
#include <span>

#include "core/surface/surfels.hpp"

namespace thaw {

/// Cosine of the angle of two surfels' normals from which on there is an edge between them: on the sphere of a single particle they turn by up to 55 degrees.
inline constexpr double cosFlat = 0.5;

/// Surfels::facets and bulge of surfel i, a third of its fan: the triangles (i, a, b) over each two that follow each other in `ring`, the neighbours that its
/// cell borders on, in turn round its normal. Where neighbours agree on their fans these are the facets of a closed mesh through the surfels, whose vector areas
/// add up to zero: sum x.facets / 3 is its volume wherever it lies, also of a film, of which sum x.n A with n from the forces is off by half. Over a facet the surface
/// bulges by area/24 sum (n_b - n_a).(x_b - x_a), of its three sides: exact to second order; by twice that between two planes that meet at an edge.
void measureFan(Surfels& surfels, std::size_t i, std::span<const std::uint32_t> ring);

}  // namespace thaw
