// SPDX-License-Identifier: Apache-2.0
// Pairs of vertices, triangles and edges of sheets that may soon touch. The list has a margin: it is rebuilt
// when motion has used that up, and extended when vertices arrive. Contact is tested for each pair in each
// step, so results do not depend on when lists are built.
#pragma once
#include "core/sheet/data/sheets.hpp"
#include "core/sheet/search/mesh_rows.hpp"
#include "core/sheet/search/near_boxes.hpp"

namespace thaw {

struct MeshCandidate {
  std::uint64_t order;                  ///< vertex and triangle number, or both edge numbers, over all meshes
  std::array<std::uint32_t, 4> vertex;  ///< numbers of the vertex and the corners, or of both ends of each
                                        ///< edge
  double reach;                         ///< m, contact distance
  bool comes;  ///< approach is predicted; false for neighbours at rest, which are always near
};

/// Motion of the vertices on this rank.
struct MeshMotion {
  Vec3d mean{};      ///< m/s, common motion, which needs no new search
  double dt = 0;     ///< s, since the last call
  double ahead = 0;  ///< s, time ahead for which pairs are listed
};

struct MeshCandidates {
  std::vector<MeshCandidate> faces, edges;  ///< in ascending order
  Vec3d shift{};                            ///< m, common displacement since the start
  std::vector<Vec3d> listed;  ///< m, position of each vertex without the shift at its last search
  /// m, for each vertex's motion besides the mean within MeshMotion::ahead. One value for all, since single
  /// vertices get faster in every step.
  double room = 0;
};

/// Returns the largest thickness (m), the limit of motion within MeshMotion::ahead.
double thickestSheet(const std::vector<SheetPlan>& plans);

/// Ratio of contact distance to rest distance within one sheet, where it is less than the thickness.
inline constexpr double nearAtRest = 0.5;

/// Updates the lists. Requires: Sheets::moving, of ghosts too.
void findMeshCandidates(const SheetBodies& sheets, const Scene& scene, const MeshRows& rows,
                        const MeshMotion& motion, MeshCandidates& candidates);

}  // namespace thaw
