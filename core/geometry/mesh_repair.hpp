// From triangles as a file has them to the surface of a solid, or to one that is open.
#pragma once
#include <cstdint>
#include <string>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// What was found and mended.
struct MeshReport {
  std::int64_t triangles = 0, vertices = 0;  ///< after merging equal vertices, before holes were closed
  std::int64_t shells = 0;                   ///< connected parts
  std::int64_t turnedTriangles = 0;          ///< turned to agree with their neighbours
  std::int64_t turnedShells = 0;             ///< were inside out
  std::int64_t holes = 0;                    ///< closed
  std::int64_t normals = 0;                  ///< that the file gives corners of triangles
  std::int64_t turnedNormals = 0;            ///< of shells most of whose normals pointed inward
  std::int64_t unusedNormals = 0;            ///< 0, or against their triangle's side
  double area = 0, holeArea = 0;             ///< m^2, of the file's triangles, of those that close holes
  double volume = 0;                         ///< m^3, signed volumes of the shells added up
  std::int64_t border = 0;                   ///< open edges of a surface that is left open (repairSurface)
  std::int64_t branched = 0;                 ///< edges of more than two triangles, as the file has them
  bool closed = true;  ///< false: so many open edges that nothing was closed; a soup, as it came
};

/// Makes a closed, outward surface:
/// 1. equal vertices are merged; if edges stay open, also those within 1e-6 of the mesh's diagonal; triangles
/// that are there twice
///    or have a corner twice go;
/// 2. within a patch (triangles joined by edges that just two of them share), triangles are turned to agree
/// with the larger part of
///    the patch's area;
/// 3. the border is followed around each hole, which is closed by triangles to the middle of its vertices. So
/// every edge is
///    balanced and winding numbers are integers off the surface;
/// 4. a shell (triangles joined by any edges) with negative volume was inside out and is turned, unless it
/// lies within another one:
///    the outermost shell decides for all within it, so that hollows stay hollows.
/// 5. normals of the file are settled (file_normals.hpp).
/// If more than 30 % of the edges are open, steps 3 and 4 are left out; only the total volume decides about
/// the direction, and inside is where the generalised winding number is more than 1/2. Throws ShapeError: no
/// triangles, an index out of range, a coordinate that is not finite, no volume enclosed.
TriangleMesh repairMesh(const TriangleMesh& mesh, MeshReport& report);

/// Of a surface that need not enclose anything: one without open edges as repairMesh does; of another steps
/// 1, 2 and 5 alone, so that it stays open, with the sides that its triangles have. Throws ShapeError as
/// repairMesh, but for what encloses no volume.
TriangleMesh repairSurface(const TriangleMesh& mesh, MeshReport& report);

/// One sentence about what was mended; empty if nothing was.
std::string describeRepairs(const std::string& name, const MeshReport& report);

}  // namespace thaw
