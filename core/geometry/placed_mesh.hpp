// The surface of a body that is a mesh, in the scene.
#pragma once
#include "core/geometry/combined.hpp"
#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

struct PlacedMesh {
  TriangleMesh mesh;  ///< repaired, in the scene; with the colours and normals of its file
  MeshReport report;
  Placement placement;  ///< of the mesh's own frame
};

/// Of a shape of kind Mesh. Throws ShapeError, or what the loader throws.
PlacedMesh makePlacedMesh(const Shape& shape, const MeshLoader& load);

/// The same of a surface that may be open, and then stays so (repairSurface).
PlacedMesh makePlacedSurface(const Shape& shape, const MeshLoader& load);

/// Moves a mesh to where the shape, of any kind, puts it. Throws ShapeError.
Placement placeMesh(const Shape& shape, TriangleMesh& mesh);

}  // namespace thaw
