// SPDX-License-Identifier: Apache-2.0
// Triangulated surfaces of the parts of a shape.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/shapes/primitives.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// Returns the surfaces of all simple parts of a shape, placed in the scene, outward from the body.
/// Subtracted parts face the other way. The result includes surface that the combined shape does not have:
/// inside another part, or outside of a cut. Chords deviate from curved faces by at most `sag` (m). Vertices
/// lie on the faces. Planes are squares larger than the body. Colours and normals of meshes are dropped.
/// Throws ShapeError; std::invalid_argument for an infinite body.
TriangleMesh shapeMesh(const Shape& shape, double sag, const MeshLoader& load);

/// Returns the shape in its own frame.
Shape withoutPlacement(Shape shape);

/// Appends the triangles of another mesh. turned: reverses them.
void appendTriangles(TriangleMesh& to, const TriangleMesh& mesh, bool turned = false);

/// Revolves an outline about z in `around` steps. A corner on the axis becomes one vertex. closed: joins the
/// last point to the first. The solid is on the left of the outline (RevolvedDistance).
TriangleMesh revolvedMesh(const std::vector<RevolvedDistance::Point>& outline, bool closed, int around);

}  // namespace thaw
