// Normals that a mesh file has.
#pragma once
#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// A normal of a file at length 1, whatever its length is there; 0 stays 0.
Vec3d unitNormal(const Vec3d& n);

/// Of a repaired mesh. A shell most of whose normals point inward (files of what is inside out, or of another
/// handedness) has all of them turned. What then still points to the other side of its triangle says nothing,
/// as does 0, which many programs write where they know none: it becomes 0 here, and the normal there follows
/// from the triangles. Counted in the report.
void settleNormals(TriangleMesh& mesh, MeshReport& report);

}  // namespace thaw
