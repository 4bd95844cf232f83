// Pairs of vertices, triangles and edges of sheets that may come to touch before long: a list with a margin, made anew when something has used that up, and added to
// when vertices come to this rank. What touches is asked of each pair in every step: no bit depends on when lists were made.
#pragma once
#include "core/sheet/mesh_rows.hpp"
#include "core/sheet/near_boxes.hpp"
#include "core/sheet/sheets.hpp"

namespace thaw {

struct World;

struct MeshCandidate {
  std::uint64_t order;                  ///< number of the vertex and the triangle, or of both edges, in all meshes
  std::array<std::uint32_t, 4> vertex;  ///< numbers of the vertex and the corners, or of both ends of each edge
  double reach;                         ///< m, at which they begin to touch
};

struct MeshCandidates {
  std::vector<MeshCandidate> faces, edges;  ///< ascending by order
  Vec3d shift{};                            ///< m, that all are taken to have moved by since the start
  std::vector<Vec3d> listed;                ///< m, place of each vertex without the shift when pairs were last sought for it
};

/// Part of the distance at rest within which the parts of one sheet touch, where that is less than the thickness.
inline constexpr double nearAtRest = 0.5;

/// Brings the lists up to date. moved: as in findMeshPairs.
void findMeshCandidates(const World& world, const MeshRows& rows, const Vec3d& moved, MeshCandidates& candidates);

}  // namespace thaw
