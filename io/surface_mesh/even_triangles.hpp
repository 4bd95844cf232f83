// SPDX-License-Identifier: Apache-2.0
// Well-shaped triangles of simple shapes, for other programs.
#pragma once
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// As shapeMesh, without slivers: faces of boxes, cylinders and glasses are divided, and balls are divided
/// icosahedra. Angles are at least 15 degrees, unless a part is more than 500 times thinner than long.
/// Meshes of files stay as they are. Requires: no difference or intersection.
TriangleMesh evenShapeMesh(const Shape& shape, double sag, const MeshLoader& load);

/// Returns a convex polygon as triangles. Rectangles are divided for angles of at least 15 degrees.
/// Requires: three corners or more, in one plane.
TriangleMesh evenPolygon(const std::vector<Vec3d>& corners);

}  // namespace thaw
