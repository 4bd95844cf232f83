// SPDX-License-Identifier: Apache-2.0
// Merging of coincident vertices.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Merges vertices within `tolerance` per axis (m; 0: only equal ones). Removes triangles with two equal
/// corners, and all but the first of triangles with the same corners. The order is preserved. Requires: valid
/// indices and finite vertices.
TriangleMesh weldVertices(const TriangleMesh& mesh, double tolerance);

}  // namespace thaw
