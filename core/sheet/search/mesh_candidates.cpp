// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/search/mesh_candidates.hpp"

#include "core/sheet/data/touching_sheets.hpp"
#include "core/sheet/search/mesh_pairs.hpp"

namespace thaw {
namespace {

// Safety factor of the fastest vertex's predicted motion, because the vertex may accelerate before the next
// rebuild.
constexpr double spare = 1.3;
constexpr double slow = 0.01;  // fraction of the largest thickness, lower limit of the predicted motion
// Fraction of the largest thickness. It is less than the difference between the distance of neighbours in a
// flat sheet and their contact distance.
constexpr double margin = 0.3;

/// Vertex, edge or triangle with all its vertices on this rank.
template<std::size_t n> struct Element {
  std::uint32_t number;
  std::array<std::uint32_t, n> row;
};

/// Elements of one type: all, and fresh ones, which are not in lists yet.
template<std::size_t n> struct Elements {
  std::vector<Element<n>> all, fresh;
  std::vector<std::uint8_t> isFresh;  // parallel to `all`
  BinnedBoxes allBoxes, freshBoxes;
  void add(const Element<n>& e, bool isNew) {
    all.push_back(e);
    isFresh.push_back(isNew);
    if (isNew) fresh.push_back(e);
  }
  void bin(const Column<Vec3d>& x, double around, const BoxBins& bins) {
    binBoxes(boxes(x, all, around), bins, allBoxes);
    binBoxes(boxes(x, fresh, around), bins, freshBoxes);
  }
  static std::vector<Box> boxes(const Column<Vec3d>& x, const std::vector<Element<n>>& list, double around) {
    std::vector<Box> b;
    b.reserve(list.size());
    for (const Element<n>& e : list) {
      std::array<Vec3d, n> corners;
      for (std::size_t k = 0; k < n; k++) corners[k] = x[e.row[k]];
      b.push_back(boxAround(corners, around));
    }
    return b;
  }
};

struct Listing {
  const SheetBodies& sheets;
  const Scene& scene;
  const MeshRows& m;
  MeshCandidates& list;
  double beyond;  // m, distance beyond contact at which pairs are listed
  Elements<1> vertices;
  Elements<2> edges;
  Elements<3> triangles;
  const Sheets& s = sheets.rows;

  template<std::size_t n> bool anyNew(const std::array<std::uint32_t, n>& rows, bool all) const {
    for (const std::uint32_t r : rows)
      if (all || !m.wasHere[m.numberOf[r]]) return true;
    return false;
  }

  void findElements(bool all) {
    std::uint32_t triangle = 0, ring = 0;
    std::vector<std::uint32_t> firstTriangle, firstRing;
    for (const SheetPlan& p : sheets.plans) {
      firstTriangle.push_back(triangle);
      firstRing.push_back(ring);
      triangle += static_cast<std::uint32_t>(p.mesh.triangles.size());
      ring += static_cast<std::uint32_t>(p.topology.ring.size());
    }
    for (std::uint32_t i = 0; i < m.numberOf.size(); i++) {
      const std::size_t n = s.body[i];
      if (!meshTouches(scene, n)) continue;
      const SheetPlan& plan = sheets.plans[n];
      const std::uint32_t v = vertexOf(s.id[i]);
      vertices.add({m.numberOf[i], {i}}, anyNew<1>({i}, all));
      for (std::uint32_t k = plan.faceFirst[v]; k < plan.faceFirst[v + 1]; k++) {
        const auto t = rowsOfTriangle(m, plan, n, plan.faceOf[k]);
        if (t[0] != noLocalRow && t[1] != noLocalRow && t[2] != noLocalRow)
          triangles.add({firstTriangle[n] + plan.faceOf[k], t}, anyNew(t, all));
      }
      for (std::uint32_t k = plan.topology.first[v]; k < plan.topology.first[v + 1]; k++) {
        const std::uint32_t to = plan.topology.ring[k].to;
        if (to < v || m.rowOf[m.first[n] + to] == noLocalRow) continue;
        const std::array<std::uint32_t, 2> e{i, m.rowOf[m.first[n] + to]};
        edges.add({firstRing[n] + k, e}, anyNew(e, all));
      }
    }
  }

  template<class PairOf>
  void add(std::uint32_t first, std::uint32_t second, const std::array<std::uint32_t, 4>& rows,
           std::vector<MeshCandidate>& to, PairOf&& pairOf) const {
    const std::size_t a = s.body[rows[0]], b = s.body[rows[3]];
    if (a == b && !scene.sheets[a].selfContact) return;
    double reach = 0.5 * (sheets.plans[a].thickness + sheets.plans[b].thickness);
    const double now = pairOf(s.position, rows).distance, least = now - beyond - 2 * list.room;
    if (!(least < reach)) return;
    const double atRest = a == b ? nearAtRest * std::min(1.0, scene.sheets[a].restLength) *
                                       pairOf(s.rest, rows).distance
                                 : reach;
    const bool comes = !(atRest < reach);
    reach = std::min(reach, atRest);
    if (!((comes ? least : now - beyond) < reach)) return;
    to.push_back({static_cast<std::uint64_t>(first) << 32 | second,
                  {m.numberOf[rows[0]], m.numberOf[rows[1]], m.numberOf[rows[2]], m.numberOf[rows[3]]},
                  reach,
                  comes});
  }
  void addFace(const Element<1>& v, const Element<3>& t) const {
    const std::uint32_t i = v.row[0];
    if (i == t.row[0] || i == t.row[1] || i == t.row[2]) return;
    add(v.number, t.number, {i, t.row[0], t.row[1], t.row[2]}, list.faces, vertexAndTriangle);
  }
  void addEdges(const Element<2>& e, const Element<2>& f) const {
    if (e.row[0] == f.row[0] || e.row[0] == f.row[1] || e.row[1] == f.row[0] || e.row[1] == f.row[1]) return;
    const Element<2>&a = e.number < f.number ? e : f, &b = e.number < f.number ? f : e;
    add(a.number, b.number, {a.row[0], a.row[1], b.row[0], b.row[1]}, list.edges, edgeAndEdge);
  }

  /// Lists all pairs with at least one fresh element.
  void findPairs() {
    double reach = 0;
    for (std::size_t n = 0; n < sheets.plans.size(); n++)
      if (meshTouches(scene, n)) reach = std::max(reach, sheets.plans[n].thickness);
    const double around = 0.5 * (reach + beyond) + list.room;
    const BoxBins forFaces = binsFor(Elements<3>::boxes(s.position, triangles.all, around)),
                  forEdges = binsFor(Elements<2>::boxes(s.position, edges.all, around));
    vertices.bin(s.position, around, forFaces);
    triangles.bin(s.position, around, forFaces);
    edges.bin(s.position, around, forEdges);
    eachNearPair(triangles.freshBoxes, vertices.allBoxes,
                 [&](std::uint32_t t, std::uint32_t v) { addFace(vertices.all[v], triangles.fresh[t]); });
    if (vertices.fresh.size() < vertices.all.size())
      eachNearPair(vertices.freshBoxes, triangles.allBoxes, [&](std::uint32_t v, std::uint32_t t) {
        if (!triangles.isFresh[t]) addFace(vertices.fresh[v], triangles.all[t]);
      });
    eachNearPair(edges.freshBoxes, edges.allBoxes, [&](std::uint32_t e, std::uint32_t f) {
      if (!edges.isFresh[f] || edges.fresh[e].number < edges.all[f].number)
        addEdges(edges.fresh[e], edges.all[f]);
    });
  }
};

/// Sorts and removes duplicates, which arise when a vertex leaves and returns.
void sortOnce(std::vector<MeshCandidate>& list) {
  std::sort(list.begin(), list.end(),
            [](const MeshCandidate& a, const MeshCandidate& b) { return a.order < b.order; });
  list.erase(std::unique(list.begin(), list.end(),
                         [](const MeshCandidate& a, const MeshCandidate& b) { return a.order == b.order; }),
             list.end());
}

}  // namespace

double thickestSheet(const std::vector<SheetPlan>& plans) {
  double thickest = 0;
  for (const SheetPlan& p : plans) thickest = std::max(thickest, p.thickness);
  return thickest;
}

void findMeshCandidates(const SheetBodies& sheets, const Scene& scene, const MeshRows& m,
                        const MeshMotion& motion, MeshCandidates& c) {
  const Sheets& s = sheets.rows;
  const double thickest = thickestSheet(sheets.plans);
  const double room = margin * thickest;
  bool all = c.listed.empty(), some = all;
  c.listed.resize(m.rowOf.size());
  c.shift += motion.mean * motion.dt;
  double fastest2 = 0;
  for (std::uint32_t i = 0; i < m.numberOf.size(); i++) {
    const Vec3d v = s.moving[i] - motion.mean;
    fastest2 = std::max(fastest2, dot(v, v));
  }
  const double comes = std::min(std::sqrt(fastest2) * motion.ahead, thickest);
  all = all || comes > c.room;
  for (std::uint32_t i = 0; i < m.numberOf.size(); i++) {
    const std::uint32_t v = m.numberOf[i];
    some = some || !m.wasHere[v];
    const Vec3d d = s.position[i] - c.shift - c.listed[v];
    all = all || (m.wasHere[v] && dot(d, d) > 0.25 * room * room);
  }
  if (!all && !some) return;
  // listed pairs may have moved by half of the margin, and may move back by as much
  Listing listing{sheets, scene, m, c, all ? room : 1.5 * room, {}, {}, {}};
  if (all) {
    c.room = std::max(spare * comes, slow * thickest);
    c.faces.clear();
    c.edges.clear();
  }
  for (std::uint32_t i = 0; i < m.numberOf.size(); i++)
    if (const std::uint32_t v = m.numberOf[i]; all || !m.wasHere[v]) c.listed[v] = s.position[i] - c.shift;
  listing.findElements(all);
  listing.findPairs();
  sortOnce(c.faces);
  sortOnce(c.edges);
}

}  // namespace thaw
