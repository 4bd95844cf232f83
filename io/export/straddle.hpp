// Meshes whose facets do not cut off what bulges between their corners.
#pragma once
#include "io/export/march_band.hpp"

namespace thaw {

/// Moves the vertices, which lie on a smooth surface with these normals, along them by the mean height of the
/// surface over the triangles around, so that facets straddle the surface and the volume is its own to second
/// order: over an edge d between normals n and m the surface bulges by d . (m - n) / 8 in the middle, over a
/// triangle by the mean of its three. No vertex moves farther than `most` (m), nor off a cut; caps are flat.
void straddle(MarchedBand& band, double most);

}  // namespace thaw
