// Pairs of vertices, triangles and edges of sheets that may come to touch before long: a list with a margin,
// made anew when something has used that up, and added to when vertices come to this rank. What touches is
// asked of each pair in every step: no bit depends on when lists were made.
#pragma once
#include "core/sheet/mesh_rows.hpp"
#include "core/sheet/near_boxes.hpp"
#include "core/sheet/sheets.hpp"

namespace thaw {

struct World;

struct MeshCandidate {
  std::uint64_t order;  ///< number of the vertex and the triangle, or of both edges, in all meshes
  std::array<std::uint32_t, 4> vertex;  ///< numbers of the vertex and the corners, or of both ends of each
                                        ///< edge
  double reach;                         ///< m, at which they begin to touch
  bool comes;  ///< it may be seen to come: not of what lies beside each other at rest, which is always near
};

/// How the vertices move, on this rank.
struct MeshMotion {
  Vec3d mean{};      ///< m/s: what is common to all costs no new search
  double dt = 0;     ///< s, since the last time
  double ahead = 0;  ///< s: pairs that come into reach within it are to be listed, too
};

struct MeshCandidates {
  std::vector<MeshCandidate> faces, edges;  ///< ascending by order
  Vec3d shift{};                            ///< m, that all are taken to have moved by since the start
  std::vector<Vec3d> listed;  ///< m, place of each vertex without the shift when pairs were last sought for
                              ///< it
  double room = 0;  ///< m, for what each vertex may come beside the mean within MeshMotion::ahead, in these
                    ///< pairs: one for all, as single ones get faster in every step
};

/// m, of the sheets; what comes further within MeshMotion::ahead is not looked for.
double thickestSheet(const World& world);

/// Part of the distance at rest within which the parts of one sheet touch, where that is less than the
/// thickness.
inline constexpr double nearAtRest = 0.5;

/// Brings the lists up to date. Needs Sheets::moving, of ghosts too.
void findMeshCandidates(const World& world, const MeshRows& rows, const MeshMotion& motion,
                        MeshCandidates& candidates);

}  // namespace thaw
