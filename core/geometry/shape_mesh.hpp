// The surface of a shape as triangles: of its parts, one by one.
#pragma once
#include "core/geometry/primitives.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// The surfaces of all simple parts of a shape, placed in the scene, outward from the body (those that are
/// taken away look the other way). What of a part is inside another one, or outside of what is cut out, is
/// there, too: combined shapes show only some of it. Chords are at most `sag` (m) off curved faces; corners
/// lie on them. Planes are squares that reach over the body. Of meshes neither colours nor normals are kept.
/// Throws ShapeError; std::invalid_argument for a body without end.
TriangleMesh shapeMesh(const Shape& shape, double sag, const MeshLoader& load);

/// The same shape in its own frame.
Shape withoutPlacement(Shape shape);

/// Turns an outline about z in `around` steps: corners on the axis are one vertex. closed: the last point is
/// joined to the first. The solid is on the left of the outline (RevolvedDistance).
TriangleMesh revolvedMesh(const std::vector<RevolvedDistance::Point>& outline, bool closed, int around);

}  // namespace thaw
