// SPDX-License-Identifier: Apache-2.0
// Removal of sliver triangles from a marched mesh.
#pragma once
#include "io/surface_mesh/march_band.hpp"

namespace thaw {

/// Remeshes the surface for well-shaped triangles (BK04): collapses short edges, flips edges to the Delaunay
/// condition, and moves vertices along the surface. Then it removes the remaining triangles with small angles
/// one by one. Necks thinner than half a cube are cut where they have such triangles. Vertices are projected
/// back onto the zero set, and normals and colours are renewed there. Caps stay flat, and vertices on their
/// rims stay or join. spacing: edge of the cubes (m). Returns the number of cuts.
std::size_t improveTriangles(MarchedBand& band, const PlaneField& planes, double spacing);

}  // namespace thaw
