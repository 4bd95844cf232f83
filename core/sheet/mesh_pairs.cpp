#include "core/sheet/mesh_pairs.hpp"

#include "core/sheet/nearest_points.hpp"
#include "core/world.hpp"

namespace thaw {
namespace {

/// Of the candidates those that touch. pairOf: what they are, vertex and triangle or two edges.
template<class PairOf> void pick(const Sheets& s, const MeshRows& m, const std::vector<MeshCandidate>& candidates, std::vector<MeshPair>& found, PairOf&& pairOf) {
  found.clear();
  for (const MeshCandidate& c : candidates) {
    const std::array<std::uint32_t, 4> rows{m.rowOf[c.vertex[0]], m.rowOf[c.vertex[1]], m.rowOf[c.vertex[2]], m.rowOf[c.vertex[3]]};
    bool all = true, ours = false;
    for (const std::uint32_t r : rows) {
      all = all && r != notHere;
      ours = ours || r < s.owned;
    }
    if (!all || !ours) continue;
    MeshPair p = pairOf(s.position, rows);
    if (!(p.distance < c.reach) || !(p.distance > 0) || !allBeside(m, rows)) continue;
    p.reach = c.reach;
    found.push_back(p);
  }
}

}  // namespace

// places from the first of four, so that the bits are those of differences
MeshPair vertexAndTriangle(const Column<Vec3d>& x, const std::array<std::uint32_t, 4>& rows) {
  const Vec3d a = x[rows[1]] - x[rows[0]], b = x[rows[2]] - x[rows[0]], c = x[rows[3]] - x[rows[0]], u = sharesOfNearest(a, b, c, {}), d = -(u.x * a + u.y * b + u.z * c);
  return {rows, {1, -u.x, -u.y, -u.z}, d, length(d), 0};
}

MeshPair edgeAndEdge(const Column<Vec3d>& x, const std::array<std::uint32_t, 4>& rows) {
  const Vec3d a = x[rows[1]] - x[rows[0]], b = x[rows[2]] - x[rows[0]], c = x[rows[3]] - x[rows[2]];
  const EdgeShares at = nearestOfEdges({}, a, b, c);
  const Vec3d d = at.first * a - (b + at.second * c);
  return {rows, {1 - at.first, at.first, at.second - 1, -at.second}, d, length(d), 0};
}

void findMeshPairs(const World& w, const Vec3d& moved, MeshSearch& search) {
  const Sheets& s = w.sheets.rows;
  findMeshCandidates(w, search.rows, moved, search.candidates);
  pick(s, search.rows, search.candidates.faces, search.faces, vertexAndTriangle);
  pick(s, search.rows, search.candidates.edges, search.edges, edgeAndEdge);
}

}  // namespace thaw
