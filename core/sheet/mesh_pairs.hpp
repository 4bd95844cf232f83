// Which vertices, triangles and edges of sheets are within reach of each other: the search of
// mesh_contact.hpp.
#pragma once
#include "core/sheet/mesh_candidates.hpp"

namespace thaw {

/// A vertex and a triangle, or two edges, nearer to each other than `reach`.
struct MeshPair {
  std::array<std::uint32_t, 4> row;  ///< vertex and corners, or both ends of each edge
  std::array<double, 4> share;  ///< of the nearest points: those of the second body are negative, and all add
                                ///< up to 0
  Vec3d apart;                  ///< m, from the second's nearest point to the first's
  double distance, reach;       ///< m
};

/// What an evaluation finds for contact by triangles.
struct MeshSearch {
  MeshRows rows;
  MeshCandidates candidates;
  std::vector<MeshPair> faces, edges;
  double coming = 0;  ///< 1/s, speed over reach of what will be within reach soon: the largest
};

/// Finds MeshSearch::faces and edges, all that one of this rank's vertices is in, ascending by the numbers of
/// both: an order that is the same on all ranks. Needs MeshSearch::rows, and Sheets::moving of ghosts too.
void findMeshPairs(const World& world, const MeshMotion& motion, MeshSearch& search);

/// The pair of these rows, with any `reach`.
MeshPair vertexAndTriangle(const Column<Vec3d>& place, const std::array<std::uint32_t, 4>& rows);
MeshPair edgeAndEdge(const Column<Vec3d>& place, const std::array<std::uint32_t, 4>& rows);

}  // namespace thaw
