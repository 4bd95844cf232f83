// SPDX-License-Identifier: Apache-2.0
// Removal of slivers along the sharp edges of a mesh.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Collapses short sides and flips long ones of triangles with an angle below 20 degrees. It does so only
/// where the surface stays in place and the angles become larger. onEdge: by vertex, 1 on a sharp edge of the
/// shape, 2 at a corner. A vertex moves only to one with the same or a higher value. Requires: a closed mesh.
void removeSlivers(TriangleMesh& mesh, const std::vector<std::uint8_t>& onEdge);

}  // namespace thaw
