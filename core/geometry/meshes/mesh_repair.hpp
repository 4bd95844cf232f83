// SPDX-License-Identifier: Apache-2.0
// Repairs the triangles of a file. They then form the surface of a solid, or an open surface.
#pragma once
#include <cstdint>
#include <string>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Numbers of defects that were found and repaired.
struct MeshReport {
  std::int64_t triangles = 0, vertices = 0;  ///< after merging equal vertices, before closing holes
  std::int64_t shells = 0;                   ///< number of connected parts
  std::int64_t turnedTriangles = 0;          ///< flipped to agree with their neighbours
  std::int64_t turnedShells = 0;             ///< inverted shells that were flipped
  std::int64_t holes = 0;                    ///< number of holes closed
  std::int64_t normals = 0;                  ///< number of corner normals in the file
  std::int64_t turnedNormals = 0;            ///< normals of shells whose normals mostly pointed inward
  std::int64_t unusedNormals = 0;            ///< normals that are 0 or oppose their triangle
  double area = 0, holeArea = 0;             ///< m^2, area of the file's triangles; area of the
                                             ///< triangles that close holes
  double volume = 0;                         ///< m^3, sum of the signed volumes of the shells
  std::int64_t border = 0;                   ///< open edges of a surface that stays open (repairSurface)
  std::int64_t branched = 0;                 ///< edges with more than two triangles in the file
  bool closed = true;  ///< false: an unconnected set of triangles, with too many open edges to close
};

/// Returns a closed, outward surface, in five steps:
///
/// 1. Equal vertices are merged; if edges stay open, also vertices within 1e-6 of the mesh's diagonal.
///    Duplicate triangles and triangles with two equal corners are removed.
/// 2. A patch is a set of triangles joined by edges that exactly two triangles share. Triangles are
///    flipped to agree with the larger part of their patch's area.
/// 3. Each hole is closed by triangles between its border and the mean of the border's vertices. Every
///    edge is then balanced, and winding numbers are integers off the surface.
/// 4. A shell (triangles joined by any edges) with negative volume is flipped, unless it lies within another
///    shell. The outermost shell decides for all shells within it, so hollows stay hollow.
/// 5. File normals are validated (file_normals.hpp).
///
/// If more than 30 % of the edges are open, steps 3 and 4 are skipped. The total volume then decides the
/// direction, and inside is where the generalised winding number exceeds 1/2. Throws ShapeError: no
/// triangles, an index out of range, a coordinate that is not finite, no volume enclosed.
TriangleMesh repairMesh(const TriangleMesh& mesh, MeshReport& report);

/// Returns a surface that may be open. A mesh without open edges is repaired as by repairMesh. For other
/// meshes, only steps 1, 2 and 5 apply: the mesh stays open, and its sides are not exchanged. Throws
/// ShapeError as repairMesh does, except for meshes that enclose no volume.
TriangleMesh repairSurface(const TriangleMesh& mesh, MeshReport& report);

/// Returns one sentence about the repairs; empty without repairs.
std::string describeRepairs(const std::string& name, const MeshReport& report);

}  // namespace thaw
