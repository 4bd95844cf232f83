// SPDX-License-Identifier: Apache-2.0
// Vertex offsets that keep the volume of coarse meshes.
#pragma once
#include "io/surface_mesh/march_band.hpp"

namespace thaw {

/// Moves vertices on a smooth surface along their normals by its mean height over adjacent triangles. Facets
/// then lie on both sides of it, and the volume is correct to second order. Over an edge d between normals n
/// and m the surface rises by d . (m - n) / 8 in the middle, over a triangle by the mean of its three edges.
/// No vertex moves farther than `most` (m), nor off a cut; caps stay flat.
void offsetVertices(MarchedBand& band, double most);

}  // namespace thaw
