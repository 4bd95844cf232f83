// SPDX-License-Identifier: Apache-2.0
// Search for vertices, triangles and edges of sheets within reach of each other, for mesh_contact.hpp.
#pragma once
#include "core/sheet/search/mesh_candidates.hpp"

namespace thaw {

/// Vertex and triangle, or two edges, at a distance below `reach`.
struct MeshPair {
  std::array<std::uint32_t, 4> row;  ///< rows of vertex and corners, or of the ends of both edges
  std::array<double, 4> share;  ///< weights of the nearest points, negative for the second body, with sum 0
  Vec3d apart;                  ///< m, from the second body's nearest point to the first's
  double distance, reach;       ///< m
};

/// Results of an evaluation's contact search.
struct MeshSearch {
  MeshRows rows;
  MeshCandidates candidates;
  std::vector<MeshPair> faces, edges;
  double coming = 0;  ///< 1/s, largest speed over reach of pairs that will soon touch
};

/// Finds MeshSearch::faces and edges with at least one of this rank's vertices. The ascending order is the
/// same on all ranks. Requires: MeshSearch::rows, and Sheets::moving, also of ghosts.
void findMeshPairs(const SheetBodies& sheets, const Scene& scene, const MeshMotion& motion,
                   MeshSearch& search);

/// Returns the pair of these rows; `reach` is not set.
MeshPair vertexAndTriangle(const Column<Vec3d>& place, const std::array<std::uint32_t, 4>& rows);
MeshPair edgeAndEdge(const Column<Vec3d>& place, const std::array<std::uint32_t, 4>& rows);

}  // namespace thaw
