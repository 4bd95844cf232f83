// SPDX-License-Identifier: Apache-2.0
// Vertex normals from a mesh file.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/meshes/mesh_repair.hpp"

namespace thaw {

/// Returns the normal scaled to length 1; 0 stays 0.
Vec3d unitNormal(const Vec3d& n);

/// Validates the file normals of a repaired mesh, and counts changes in the report. If most normals of a
/// shell point inward (an inverted file, or another handedness), all its normals are flipped. Normals that
/// still oppose their triangle are then set to 0. Many files also use 0 for missing normals. Normals of 0 are
/// computed from the triangles.
void validateNormals(TriangleMesh& mesh, MeshReport& report);

}  // namespace thaw
