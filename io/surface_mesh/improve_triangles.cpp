// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/improve_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "io/surface_mesh/triangle_angles.hpp"
#include "io/surface_mesh/triangle_edits.hpp"

namespace thaw {

namespace {

constexpr int rounds = 2;
/// The first rounds project only to within the height of a facet.
constexpr int roundsWithoutProjection = 1;
/// Edges below this length, in cubes, collapse.
constexpr double shortEdge = 0.55;
/// A collapse makes no edge longer than this, in cubes.
constexpr double longEdge = 1.4;
/// Least cosine between the normals of a triangle before and after a change: first in the rounds, then in
/// each repair pass.
constexpr double leastTurn = 0.7;
constexpr double leastTurnOfRepairs[] = {0.7, 0.7, 0.5, 0.5, 0.2, 0.2, -0.2, -0.2, -0.5, -0.5};
/// Cosines of 20 and 12 degrees. Triangles with sharper angles are repaired one by one; those below 12
/// degrees even if triangles rotate.
constexpr double sharp = 0.9397, verySharp = 0.9781;
/// Necks with no edge above this length, in cubes, are cut.
constexpr double widestNeck = 0.5;

class Improver {
 public:
  Improver(MarchedBand& band, const PlaneField& planes, double spacing)
      : band_(band), m_(band.mesh), planes_(planes), spacing_(spacing), edits_(band.mesh.mesh) {}

  /// Returns the number of necks that were cut.
  std::size_t run() {
    for (int k = 0; k < rounds; k++) {
      projects_ = k >= roundsWithoutProjection;
      collapseShortEdges();
      flipEdges();
      relaxVertices();
    }
    projects_ = true;
    for (const double turn : leastTurnOfRepairs) {
      leastTurn_ = turn;
      if (repairSharpTriangles() == 0) break;
    }
    finish();
    return cuts_;
  }

 private:
  using Triangle = TriangleEdits::Triangle;

  const Vec3d& at(std::uint32_t v) const { return m_.mesh.vertices[v]; }
  Vec3d normalOf(std::uint32_t v) const { return wide(m_.normals[v]); }
  /// Returns whether a vertex lies on a cut.
  bool isOnCut(std::uint32_t v) const { return band_.fixedAxes[v] != 0; }
  /// Returns whether a vertex lies inside a cap, off the cap's rim and the edges of the domain.
  bool isInCap(std::uint32_t v) const {
    const int axes = band_.fixedAxes[v] & ~MarchedBand::onCap;
    return (band_.fixedAxes[v] & MarchedBand::onCap) && (axes & (axes - 1)) == 0;
  }
  bool isFixed(std::uint32_t v) const { return isOnCut(v) && !isInCap(v); }
  /// Returns whether one vertex may collapse to another: it stays on its cuts, and no rim moves into a cap.
  bool staysOnCuts(std::uint32_t from, std::uint32_t to) const {
    const int own = band_.fixedAxes[from], others = band_.fixedAxes[to];
    if (!(own & MarchedBand::onCap) && (others & MarchedBand::onCap)) return false;
    for (int a = 0; a < 3; a++)
      if ((own >> a & 1) && (!(others >> a & 1) || at(from)[a] != at(to)[a])) return false;
    return true;
  }

  /// Returns whether product > cosine * sqrt(squares).
  static bool exceedsCosine(double product, double cosine, double squares) {
    const double bound = cosine * cosine * squares;
    return cosine < 0 ? product > 0 || product * product < bound : product > 0 && product * product > bound;
  }
  static Vec3d areaNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a); }

  /// Positions of a triangle's corners with vertex v at x.
  std::array<Vec3d, 3> cornersWith(const Triangle& t, std::uint32_t v, const Vec3d& x) const {
    return {t[0] == v ? x : at(t[0]), t[1] == v ? x : at(t[1]), t[2] == v ? x : at(t[2])};
  }

  /// Returns whether a triangle keeps its direction when vertex v moves to x. A small triangle may turn in
  /// any direction that its vertices' normals agree with. In the last passes it may turn in any direction.
  bool keepsDirection(const Triangle& t, std::uint32_t v, const Vec3d& x) const {
    const auto c = cornersWith(t, v, x);
    const Vec3d before = areaNormal(at(t[0]), at(t[1]), at(t[2])), after = areaNormal(c[0], c[1], c[2]);
    const double l2 = dot(after, after), was2 = dot(before, before), unit = spacing_ * spacing_;
    if (!(l2 > 1e-10 * unit * unit)) return false;
    const bool isFlat = (band_.fixedAxes[t[0]] & band_.fixedAxes[t[1]] & band_.fixedAxes[t[2]] & 7) != 0;
    if (isFlat) return dot(before, after) > 0;
    if (was2 > 4e-4 * unit * unit) return exceedsCosine(dot(before, after), leastTurn_, was2 * l2);
    if (leastTurn_ < leastTurn) return true;
    const Vec3d mean = normalOf(t[0]) + normalOf(t[1]) + normalOf(t[2]);
    return exceedsCosine(dot(mean, after), 0.3, dot(mean, mean) * l2);
  }

  /// Returns the cosine of the smallest angle around a vertex that moves to x, without triangles of
  /// `without`.
  double sharpestAround(std::uint32_t v, const Vec3d& x, std::uint32_t without) const {
    double sharpest = -1;
    for (const std::uint32_t t : edits_.around(v)) {
      const Triangle& c = edits_.triangle(t);
      if (std::find(c.begin(), c.end(), without) != c.end()) continue;
      const auto p = cornersWith(c, v, x);
      sharpest = std::max(sharpest, sharpestCosine(p[0], p[1], p[2]));
    }
    return sharpest;
  }

  bool keepsDirections(std::uint32_t v, const Vec3d& x, std::uint32_t without) const {
    for (const std::uint32_t t : edits_.around(v)) {
      const Triangle& c = edits_.triangle(t);
      if (std::find(c.begin(), c.end(), without) == c.end() && !keepsDirection(c, v, x)) return false;
    }
    return true;
  }

  bool makesLongEdge(std::uint32_t v, const Vec3d& x) {
    edits_.neighboursOf(v, near_);
    for (const std::uint32_t n : near_)
      if (length(at(n) - x) > longEdge * spacing_) return true;
    return false;
  }

  /// Projects a position onto the surface near vertex v. Returns false where the surface is not defined, or
  /// is that of another side.
  bool project(std::uint32_t v, Vec3d& x, PlaneHeight& here) const {
    if (!projects_ || isInCap(v)) return true;
    here = planes_.at(x);
    if (!here.known || std::abs(here.value) > 0.3 * spacing_) return false;
    const Vec3d n = wide(here.normal);
    const double l = length(n);
    if (!(l > 0) || dot(n, normalOf(v)) < 0.5 * l) return false;
    x -= here.value / l * n;
    return true;
  }

  void place(std::uint32_t v, const Vec3d& x, const PlaneHeight& here) {
    m_.mesh.vertices[v] = x;
    if (!here.known) return;
    const float l = std::sqrt(dot(here.normal, here.normal));
    if (l > 0) m_.normals[v] = here.normal / l;
    m_.colours[v] = here.colour;
  }

  /// Position and surface that an edge collapses to.
  struct Target {
    std::uint32_t from, to;
    Vec3d x;
    PlaneHeight here;
    double sharpest = 1;
  };

  /// Returns whether the edge may collapse to the target, and sets the cosine of its smallest angle.
  bool accepts(Target& t) {
    if (!keepsDirections(t.from, t.x, t.to) || !keepsDirections(t.to, t.x, t.from)) return false;
    t.sharpest = std::max(sharpestAround(t.from, t.x, t.to), sharpestAround(t.to, t.x, t.from));
    return true;
  }

  /// Returns the best collapse of an edge, or none (sharpest 1): to either end, or to the middle.
  Target bestCollapse(std::uint32_t a, std::uint32_t b) {
    Target best{a, b, {}, {}};
    if (!edits_.mayCollapse(a, b)) return best;
    for (int k = 0; k < 3; k++) {
      Target t{a, b, at(b), {}};
      if (k == 1) t = {b, a, at(a), {}};
      if (!staysOnCuts(t.from, t.to)) continue;
      if (k == 2 && (isFixed(a) || isFixed(b) || isInCap(a) != isInCap(b))) continue;
      if (k == 2) {
        t.x = 0.5 * (at(a) + at(b));
        if (!project(b, t.x, t.here)) continue;
      }
      if (accepts(t) && t.sharpest < best.sharpest) best = t;
    }
    return best;
  }

  void collapse(const Target& t) {
    edits_.collapse(t.from, t.to);
    place(t.to, t.x, t.here);
  }

  void collapseShortEdges() {
    std::vector<std::uint32_t> list;
    const auto count = static_cast<std::uint32_t>(m_.mesh.vertices.size());
    for (std::uint32_t a = 0; a < count; a++) {
      edits_.neighboursOf(a, list);
      std::erase_if(list, [&](std::uint32_t b) {
        const Vec3d along = at(b) - at(a);
        return !(dot(along, along) < shortEdge * shortEdge * spacing_ * spacing_);
      });
      if (list.empty()) continue;
      // shortest first, so that few collapses suffice
      const auto size = [&](std::uint32_t b) { return length(at(b) - at(a)); };
      std::sort(list.begin(), list.end(), [&](std::uint32_t b, std::uint32_t c) {
        const double lb = size(b), lc = size(c);
        return lb != lc ? lb < lc : b < c;
      });
      for (const std::uint32_t b : list) {
        const bool isFlat = isInCap(a) || isInCap(b);
        if (!isFlat && dot(m_.normals[a], m_.normals[b]) < 0.6f && size(b) > 0.2 * spacing_) continue;
        const Target best = bestCollapse(a, b);
        if (best.sharpest > 0.97 || makesLongEdge(best.from, best.x)) continue;
        collapse(best);
        break;
      }
    }
  }

  /// Returns whether an edge keeps its place: on the rim of a cap, or where caps meet.
  bool isRim(std::uint32_t a, std::uint32_t b, const TriangleEdits::Edge& e) const {
    const int axes = band_.fixedAxes[a] & band_.fixedAxes[b] & 7;
    return isOnCut(a) && isOnCut(b) && (axes & band_.fixedAxes[e.left] & band_.fixedAxes[e.right]) == 0;
  }

  /// Returns whether the flip of an edge improves the smallest angle of its triangles.
  bool flipImproves(std::uint32_t a, std::uint32_t b, const TriangleEdits::Edge& e) const {
    const Vec3d &p = at(a), &q = at(b), &l = at(e.left), &r = at(e.right);
    const double before = std::max(sharpestCosine(p, q, l), sharpestCosine(q, p, r)),
                 after = std::max(sharpestCosine(l, p, r), sharpestCosine(r, q, l));
    if (after > before - 1e-9) return false;
    const Vec3d n = areaNormal(p, q, l), m = areaNormal(q, p, r), u = areaNormal(l, p, r),
                v = areaNormal(r, q, l);
    const Vec3d mean = n + m;
    const double size = length(mean);
    if (!(dot(mean, u) > leastTurn_ * size * length(u)) || !(dot(mean, v) > leastTurn_ * size * length(v)))
      return false;
    return length(l - r) < longEdge * spacing_ || length(l - r) < length(p - q);
  }

  void flipEdges() {
    const auto count = static_cast<std::uint32_t>(m_.mesh.triangles.size());
    for (int k = 0; k < 2; k++)
      for (std::uint32_t t = 0; t < count; t++) {
        if (!edits_.exists(t)) continue;
        const Triangle c = edits_.triangle(t);
        // Only the longest edge of a triangle may gain by a flip.
        std::size_t longest = 0;
        double most = 0;
        for (std::size_t j = 0; j < 3; j++) {
          const Vec3d along = at(c[(j + 1) % 3]) - at(c[j]);
          if (dot(along, along) > most) most = dot(along, along), longest = j;
        }
        const std::uint32_t a = c[longest], b = c[(longest + 1) % 3];
        const TriangleEdits::Edge e = edits_.edge(a, b);
        if (e.found() && !isRim(a, b, e) && flipImproves(a, b, e) && edits_.mayFlip(a, b, e))
          edits_.flip(a, b, e);
      }
  }

  /// Returns the mean of the triangles' centroids around a vertex, weighted by area.
  Vec3d centroidAround(std::uint32_t v) const {
    Vec3d sum{};
    double area = 0;
    for (const std::uint32_t t : edits_.around(v)) {
      const Triangle& c = edits_.triangle(t);
      const double size = length(areaNormal(at(c[0]), at(c[1]), at(c[2])));
      area += size;
      sum += size / 3 * (at(c[0]) + at(c[1]) + at(c[2]));
    }
    return area > 0 ? sum / area : at(v);
  }

  /// Moves a vertex along the surface to x. Returns false, without a change, if a triangle would turn or an
  /// angle would become too sharp. This is so if the cosine of the smallest angle around it exceeds `most`
  /// and, with `orNow`, its present value.
  bool moveTo(std::uint32_t v, Vec3d x, double most, bool orNow = false) {
    const Vec3d n = normalOf(v);
    x -= dot(x - at(v), n) * n;
    for (int a = 0; a < 3; a++)
      if (band_.fixedAxes[v] >> a & 1) x[a] = at(v)[a];
    PlaneHeight here;
    if (!project(v, x, here)) here.known = false;
    if (!keepsDirections(v, x, TriangleEdits::removed)) return false;
    const double sharpest = sharpestAround(v, x, TriangleEdits::removed);
    if (sharpest > most && !(orNow && sharpest <= sharpestAround(v, at(v), TriangleEdits::removed)))
      return false;
    place(v, x, here);
    return true;
  }

  void relaxVertices() {
    for (std::uint32_t v = 0; v < m_.mesh.vertices.size(); v++) {
      if (isFixed(v) || edits_.around(v).empty()) continue;
      moveTo(v, centroidAround(v), 0.85, true);
    }
  }

  /// Cuts a neck at the shortest edge of a triangle. Returns whether there was one.
  bool cutNeckAt(const Triangle& t) {
    std::size_t k = 0;
    const auto size = [&](std::uint32_t a, std::uint32_t b) { return length(at(a) - at(b)); };
    for (std::size_t j = 1; j < 3; j++)
      if (size(t[j], t[(j + 1) % 3]) < size(t[k], t[(k + 1) % 3])) k = j;
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = edits_.neckAt(a, b);
    if (c == TriangleEdits::removed || isOnCut(a) || isOnCut(b) || isOnCut(c)) return false;
    if (std::max({size(a, b), size(b, c), size(c, a)}) > widestNeck * spacing_) return false;
    if (!edits_.cutNeck({a, b, c})) return false;
    for (const std::uint32_t v : {a, b, c}) {
      m_.normals.push_back(Vec3f(m_.normals[v]));
      m_.colours.push_back(Vec3f(m_.colours[v]));
      band_.fixedAxes.push_back(0);
    }
    cuts_++;
    return true;
  }

  /// Tries all changes at a triangle, and makes the best.
  void repair(std::uint32_t t) {
    const Triangle c = edits_.triangle(t);
    if (cutNeckAt(c)) return;
    const double now = sharpestCosine(at(c[0]), at(c[1]), at(c[2]));
    Target best{0, 0, {}, {}};
    for (std::size_t k = 0; k < 3; k++) {
      const Target to = bestCollapse(c[k], c[(k + 1) % 3]);
      if (to.sharpest < best.sharpest) best = to;
    }
    if (best.sharpest < std::min(now - 1e-6, sharp)) return collapse(best);
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint32_t a = c[k], b = c[(k + 1) % 3];
      const TriangleEdits::Edge e = edits_.edge(a, b);
      if (!edits_.mayFlip(a, b, e) || isRim(a, b, e) || !flipImproves(a, b, e)) continue;
      edits_.flip(a, b, e);
      return;
    }
    for (const std::uint32_t v : c) {
      if (isFixed(v)) continue;
      const double around = sharpestAround(v, at(v), TriangleEdits::removed);
      if (moveTo(v, centroidAround(v), around - 1e-6)) return;
    }
    // Equal angles remain in rows of slivers, until the last one is gone.
    if (best.sharpest < now + 1e-6) collapse(best);
  }

  /// Returns the number of sharp triangles that were found.
  std::size_t repairSharpTriangles() {
    std::size_t found = 0;
    for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); t++) {
      if (!edits_.exists(t)) continue;
      const Triangle& c = edits_.triangle(t);
      const double cosine = sharpestCosine(at(c[0]), at(c[1]), at(c[2]));
      if (!(cosine > (leastTurn_ > 0.3 ? sharp : verySharp))) continue;
      found++;
      repair(t);
    }
    return found;
  }

  void finish() {
    const std::vector<std::uint32_t> kept = edits_.compact();
    for (std::size_t v = 0; v < kept.size(); v++)
      m_.normals[v] = m_.normals[kept[v]], m_.colours[v] = m_.colours[kept[v]],
      band_.fixedAxes[v] = band_.fixedAxes[kept[v]];
    m_.normals.resize(kept.size());
    m_.colours.resize(kept.size());
    band_.fixedAxes.resize(kept.size());
  }

  MarchedBand& band_;
  ComponentMesh& m_;
  const PlaneField& planes_;
  const double spacing_;
  double leastTurn_ = leastTurn;
  bool projects_ = false;
  std::size_t cuts_ = 0;
  TriangleEdits edits_;
  std::vector<std::uint32_t> near_;
};

}  // namespace

std::size_t improveTriangles(MarchedBand& band, const PlaneField& planes, double spacing) {
  return Improver(band, planes, spacing).run();
}

}  // namespace thaw
