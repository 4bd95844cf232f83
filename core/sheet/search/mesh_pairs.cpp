// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/search/mesh_pairs.hpp"

#include "core/sheet/search/nearest_points.hpp"

namespace thaw {
namespace {

/// Selects the candidates that touch. Returns the largest approach rate (1/s, speed over reach) of
/// candidates that will touch within `ahead` (s), with motion limited to `farthest` (m). pairOf makes the
/// pair of a vertex and a triangle, or of two edges.
template<class PairOf>
double pick(const Sheets& s, const MeshRows& m, const std::vector<MeshCandidate>& candidates, double ahead,
            double farthest, std::vector<MeshPair>& found, PairOf&& pairOf) {
  double coming = 0;
  found.clear();
  for (const MeshCandidate& c : candidates) {
    const std::array<std::uint32_t, 4> rows{m.rowOf[c.vertex[0]], m.rowOf[c.vertex[1]], m.rowOf[c.vertex[2]],
                                            m.rowOf[c.vertex[3]]};
    bool all = true, ours = false;
    for (const std::uint32_t r : rows) {
      all = all && r != noLocalRow;
      ours = ours || r < s.owned;
    }
    if (!all || !ours) continue;
    MeshPair p = pairOf(s.position, rows);
    if (!(p.distance > 0)) continue;
    double rate = 0;  // m/s, rate of approach
    if (p.distance >= c.reach) {
      if (!c.comes) continue;
      for (std::size_t k = 0; k < 4; k++) rate -= p.share[k] * dot(s.moving[rows[k]], p.apart) / p.distance;
      if (!(p.distance - std::min(rate * ahead, farthest) < c.reach)) continue;
    }
    if (!allAdjacent(m, rows)) continue;
    p.reach = c.reach;
    if (p.distance < c.reach) found.push_back(p);
    else coming = std::max(coming, rate / c.reach);
  }
  return coming;
}

}  // namespace

// positions relative to the first of four, so the bits depend only on differences
MeshPair vertexAndTriangle(const Column<Vec3d>& x, const std::array<std::uint32_t, 4>& rows) {
  const Vec3d a = x[rows[1]] - x[rows[0]], b = x[rows[2]] - x[rows[0]], c = x[rows[3]] - x[rows[0]],
              u = sharesOfNearest(a, b, c, {}), d = -(u.x * a + u.y * b + u.z * c);
  return {rows, {1, -u.x, -u.y, -u.z}, d, length(d), 0};
}

MeshPair edgeAndEdge(const Column<Vec3d>& x, const std::array<std::uint32_t, 4>& rows) {
  const Vec3d a = x[rows[1]] - x[rows[0]], b = x[rows[2]] - x[rows[0]], c = x[rows[3]] - x[rows[2]];
  const EdgeShares at = nearestOfEdges({}, a, b, c);
  const Vec3d d = at.first * a - (b + at.second * c);
  return {rows, {1 - at.first, at.first, at.second - 1, -at.second}, d, length(d), 0};
}

void findMeshPairs(const SheetBodies& sheets, const Scene& scene, const MeshMotion& motion,
                   MeshSearch& search) {
  const Sheets& s = sheets.rows;
  findMeshCandidates(sheets, scene, search.rows, motion, search.candidates);
  const double farthest = thickestSheet(sheets.plans);
  search.coming = std::max(
      pick(s, search.rows, search.candidates.faces, motion.ahead, farthest, search.faces, vertexAndTriangle),
      pick(s, search.rows, search.candidates.edges, motion.ahead, farthest, search.edges, edgeAndEdge));
}

}  // namespace thaw
