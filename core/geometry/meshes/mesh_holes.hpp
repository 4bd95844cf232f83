// SPDX-License-Identifier: Apache-2.0
// Closes the holes of a mesh.
#pragma once
#include <cstdint>

#include "core/geometry/meshes/mesh_edges.hpp"

namespace thaw {

/// Closes each hole with triangles between its border and the mean of the border's vertices. Every edge is
/// then traversed equally often in both directions. sides: edgeSides of the input mesh. Returns the number of
/// holes.
std::int64_t closeHoles(TriangleMesh& mesh, const AlignedVector<EdgeSide>& sides);

}  // namespace thaw
