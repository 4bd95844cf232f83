// Vertices of a mesh that lie on each other become one.
#pragma once
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// Merges vertices not farther apart than `tolerance` per axis (m; 0: only equal ones) and removes triangles
/// that have a corner twice, and all but the first of those with the same three corners. Order is kept.
/// Indices have to be valid, vertices finite.
TriangleMesh weldVertices(const TriangleMesh& mesh, double tolerance);

}  // namespace thaw
