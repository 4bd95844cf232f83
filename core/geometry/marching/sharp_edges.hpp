// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a marched surface.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Projects the vertices of a marched surface onto the shape, and divides triangles along its edges, where
/// normals turn by more than 30 degrees. Points on edges are where the tangent planes at both ends of a
/// triangle's side meet; corners are where three meet (KBSS01). Closed meshes stay closed.
/// spacing: edge (m) of the cubes.
TriangleMesh withSharpEdges(const TriangleMesh& mesh, const SignedDistance& shape, double spacing);

/// As withSharpEdges, but moves the nearer end of each side onto the edge and divides none. Returns 0 for
/// each vertex on a face, 1 on an edge, 2 at a corner.
std::vector<std::uint8_t> moveOntoEdges(TriangleMesh& mesh, const SignedDistance& shape, double spacing);

}  // namespace thaw
