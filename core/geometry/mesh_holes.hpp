// Closing the holes of a mesh.
#pragma once
#include <cstdint>

#include "core/geometry/mesh_edges.hpp"

namespace thaw {

/// Adds triangles (and vertices) so that every edge is run through as often one way as the other: follows the
/// border around each hole and joins it to the middle of its vertices. sides: edgeSides of the mesh as it
/// comes in. Returns the number of holes.
std::int64_t closeHoles(TriangleMesh& mesh, const AlignedVector<EdgeSide>& sides);

}  // namespace thaw
