// SPDX-License-Identifier: Apache-2.0
// Pairs of vertices, triangles and edges of sheets that may soon touch. The list has a margin. It is rebuilt
// when motion has used up the margin, and extended when vertices arrive. Contact is tested for each pair in
// each step, so results do not depend on the time of the rebuild.
#pragma once
#include "core/sheet/data/sheets.hpp"
#include "core/sheet/search/mesh_rows.hpp"
#include "core/sheet/search/near_boxes.hpp"

namespace thaw {

struct MeshCandidate {
  std::uint64_t order;                  ///< numbers over all meshes, of vertex and triangle or of both edges
  std::array<std::uint32_t, 4> vertex;  ///< vertex numbers: of the vertex and the corners, or of the ends of
                                        ///< both edges
  double reach;                         ///< m, contact distance
  bool comes;  ///< true if approach is predicted; false for elements that are neighbours at rest, since they
               ///< are always near
};

/// Motion of the vertices on this rank.
struct MeshMotion {
  Vec3d mean{};      ///< m/s, common velocity, which needs no new search
  double dt = 0;     ///< s, since the last call
  double ahead = 0;  ///< s, future time for which pairs are listed
};

struct MeshCandidates {
  std::vector<MeshCandidate> faces, edges;  ///< in ascending order
  Vec3d shift{};                            ///< m, common displacement since the start
  std::vector<Vec3d> listed;  ///< m, position of each vertex without the shift at its last search
  /// m, allowance for each vertex's motion relative to the mean within MeshMotion::ahead. It is one value for
  /// all vertices, since in every step some vertex becomes faster.
  double room = 0;
};

/// Returns the largest thickness (m). It limits the motion within MeshMotion::ahead.
double thickestSheet(const std::vector<SheetPlan>& plans);

/// Ratio of contact distance to rest distance within one sheet, if the result is less than the thickness.
inline constexpr double nearAtRest = 0.5;

/// Updates the lists. Requires: Sheets::moving, also of ghosts.
void findMeshCandidates(const SheetBodies& sheets, const Scene& scene, const MeshRows& rows,
                        const MeshMotion& motion, MeshCandidates& candidates);

}  // namespace thaw
