// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a marched surface.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Projects the vertices of a marched surface onto the shape. Divides triangles along the shape's edges,
/// where normals turn by more than 30 degrees. A point on an edge is the intersection of the tangent planes
/// at both ends of a triangle's side. A corner is the intersection of three tangent planes (KBSS01). Closed
/// meshes stay closed.
/// spacing: edge (m) of the cubes.
TriangleMesh withSharpEdges(const TriangleMesh& mesh, const SignedDistance& shape, double spacing);

/// As withSharpEdges, but moves the closer end of each side onto the edge and divides no triangle. Returns 0
/// for each vertex on a face, 1 on an edge, 2 at a corner. spacing: m.
std::vector<std::uint8_t> moveOntoEdges(TriangleMesh& mesh, const SignedDistance& shape, double spacing);

}  // namespace thaw
