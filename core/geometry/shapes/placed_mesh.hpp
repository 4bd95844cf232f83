// SPDX-License-Identifier: Apache-2.0
// Meshes of bodies placed in the scene.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/meshes/mesh_repair.hpp"
#include "core/geometry/shapes/combined.hpp"

namespace thaw {

struct PlacedMesh {
  TriangleMesh mesh;  ///< repaired mesh in the frame of the scene, with the colours and normals of the file
  MeshReport report;
  Placement placement;  ///< placement of the mesh's own frame
};

/// Returns the repaired mesh of a shape. Requires: ShapeKind::Mesh. Throws ShapeError and the loader's
/// exceptions.
PlacedMesh makePlacedMesh(const Shape& shape, const MeshLoader& load);

/// As makePlacedMesh, but an open surface stays open (repairSurface).
PlacedMesh makePlacedSurface(const Shape& shape, const MeshLoader& load);

/// Returns the placement of a shape of any kind. mesh: the shape's surface in its own frame. Throws
/// ShapeError.
Placement placementOfMesh(const Shape& shape, const TriangleMesh& mesh);

/// Applies the placement of a shape of any kind to a mesh. Throws ShapeError.
Placement placeMesh(const Shape& shape, TriangleMesh& mesh);

}  // namespace thaw
