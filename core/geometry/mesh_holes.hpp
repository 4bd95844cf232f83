// Closing the holes of a mesh.
#pragma once
#include <cstdint>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// Adds triangles (and vertices) so that every edge is run through as often one way as the other: follows the border around each
/// hole and joins it to the middle of its vertices. Returns the number of holes.
std::int64_t closeHoles(TriangleMesh& mesh);

}  // namespace thaw
