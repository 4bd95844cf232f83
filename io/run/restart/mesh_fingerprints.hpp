// SPDX-License-Identifier: Apache-2.0
// Checksums of the meshes of a scene, for the restart record.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns counts and checksum of the vertices and triangles of a file.
MeshFingerprint fingerprintOf(const TriangleMesh& mesh);

/// Fills Shape::meshFingerprint of all meshes of a scene; reads each file once. Throws ShapeError with all
/// files that cannot be read.
void fingerprintMeshes(Scene& scene, const MeshLoader& load);

}  // namespace thaw
