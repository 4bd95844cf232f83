// The contents of the meshes that a scene names, for the marks of its checkpoints.
#pragma once
#include "core/geometry/triangle_mesh.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Of vertices and triangles as a file has them.
MeshMark markOf(const TriangleMesh& mesh);

/// Fills Shape::meshMark of all shapes of a scene that are meshes; each file is read once. Throws ShapeError
/// with all that cannot be read.
void markMeshes(Scene& scene, const MeshLoader& load);

}  // namespace thaw
