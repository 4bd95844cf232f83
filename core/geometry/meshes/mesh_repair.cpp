// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/meshes/file_normals.hpp"
#include "core/geometry/meshes/mesh_edges.hpp"
#include "core/geometry/meshes/mesh_holes.hpp"
#include "core/geometry/meshes/weld_vertices.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/math/disjoint_sets.hpp"

namespace thaw {
namespace {

constexpr double weldTolerance = 1e-6;  // fraction of the diagonal
constexpr double soupFraction = 0.3;    // fraction of open edges
constexpr double flat = 1e-9;  // volume over area^(3/2) of a surface that encloses nothing; 0.094 for a ball
constexpr std::size_t mostContainers = 1000;

double areaOf(const TriangleMesh& m, const std::array<std::uint32_t, 3>& t) {
  return 0.5 * length(cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]));
}

double volumeOf(const TriangleMesh& m, const std::array<std::uint32_t, 3>& t, const Vec3d& origin) {
  return dot(m.vertices[t[0]] - origin, cross(m.vertices[t[1]] - origin, m.vertices[t[2]] - origin)) / 6;
}

void turn(TriangleMesh& m, std::size_t t) {
  std::swap(m.triangles[t][1], m.triangles[t][2]);
  if (!m.normals.empty()) std::swap(m.normals[t][1], m.normals[t][2]);
}

void check(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw ShapeError("the mesh has no triangles; expected the closed surface of a solid");
  for (const Vec3d& v : mesh.vertices)
    if (!(std::abs(v.x) < 1e100 && std::abs(v.y) < 1e100 && std::abs(v.z) < 1e100))
      throw ShapeError("the mesh has a vertex with a coordinate that is not a finite number");
  const std::size_t n = mesh.vertices.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); t++)
    for (const std::uint32_t v : mesh.triangles[t])
      if (v >= n)
        throw ShapeError("triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) +
                         ", but the mesh has " + std::to_string(n) + " (0 to " + std::to_string(n - 1) + ")");
}

std::size_t openEdges(const AlignedVector<EdgeSide>& sides, std::size_t& edges) {
  std::size_t open = 0;
  edges = 0;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) { edges++, open += last - first == 1; });
  return open;
}

/// Step 2. Returns the number of flipped triangles; their sides are flipped as well.
std::int64_t orientPatches(TriangleMesh& m, AlignedVector<EdgeSide>& sides) {
  const std::size_t n = m.triangles.size();
  struct Link {
    std::uint32_t other = 0xffffffffu;
    bool opposed = false;
  };
  std::vector<std::array<Link, 3>> links(n);
  std::vector<std::uint8_t> used(n, 0);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first != 2) return;
    const EdgeSide &a = sides[first], &b = sides[first + 1];
    const bool opposed = a.sign == b.sign;  // consistent neighbours traverse their edge in opposite
                                            // directions
    links[a.triangle][used[a.triangle]++] = {b.triangle, opposed};
    links[b.triangle][used[b.triangle]++] = {a.triangle, opposed};
  });
  enum : std::uint8_t { Unseen, Kept, Turned };
  std::vector<std::uint8_t> state(n, Unseen);
  std::vector<std::uint32_t> patch;
  std::int64_t turned = 0;
  for (std::uint32_t seed = 0; seed < n; seed++) {
    if (state[seed] != Unseen) continue;
    patch.assign(1, seed);
    state[seed] = Kept;
    double kept = 0, other = 0;
    for (std::size_t k = 0; k < patch.size(); k++) {
      const std::uint32_t t = patch[k];
      (state[t] == Kept ? kept : other) += areaOf(m, m.triangles[t]);
      for (std::size_t l = 0; l < used[t]; l++) {
        const Link& link = links[t][l];
        if (state[link.other] != Unseen) continue;
        state[link.other] = (state[t] == Kept) != link.opposed ? Kept : Turned;
        patch.push_back(link.other);
      }
    }
    const std::uint8_t wrong = other > kept ? Kept : Turned;
    for (const std::uint32_t t : patch) {
      state[t] = state[t] == wrong ? Turned : Kept;
      if (state[t] == Turned) turn(m, t), turned++;
    }
  }
  if (turned > 0)
    for (EdgeSide& s : sides)
      if (state[s.triangle] == Turned) s.sign = static_cast<std::int8_t>(-s.sign);
  return turned;
}

struct Shell {
  std::vector<std::uint32_t> triangles;
  Vec3d low{never, never, never}, high{-never, -never, -never};
  double volume = 0, area = 0;
  bool solid() const { return std::abs(volume) > flat * std::pow(area, 1.5); }
};

std::vector<Shell> findShells(const TriangleMesh& m, const AlignedVector<EdgeSide>& sides) {
  DisjointSets sets(m.triangles.size());
  for (std::size_t k = 1; k < sides.size(); k++)
    if (sides[k].edge == sides[k - 1].edge) sets.join(sides[k].triangle, sides[k - 1].triangle);
  std::vector<std::uint32_t> number(m.triangles.size());
  std::vector<Shell> shells;
  for (std::uint32_t t = 0; t < m.triangles.size(); t++) {
    const std::uint32_t root = sets.find(t);
    if (root == t) {
      number[t] = static_cast<std::uint32_t>(shells.size());
      shells.emplace_back();
    }
    Shell& s = shells[number[root]];
    s.triangles.push_back(t);
    for (const std::uint32_t v : m.triangles[t])
      for (int a = 0; a < 3; a++) {
        s.low[a] = std::min(s.low[a], m.vertices[v][a]);
        s.high[a] = std::max(s.high[a], m.vertices[v][a]);
      }
  }
  for (Shell& s : shells)
    for (const std::uint32_t t : s.triangles) {
      s.volume += volumeOf(m, m.triangles[t], 0.5 * (s.low + s.high));
      s.area += areaOf(m, m.triangles[t]);
    }
  return shells;
}

/// Returns true if `outer` contains about 16 evenly selected vertices of `inner`.
bool contains(const TriangleBvh& outer, const TriangleMesh& m, const Shell& inner) {
  const std::size_t step = std::max<std::size_t>(1, inner.triangles.size() / 16);
  for (std::size_t k = 0; k < inner.triangles.size(); k += step)
    if (std::abs(outer.winding(m.vertices[m.triangles[inner.triangles[k]][0]])) < 0.5) return false;
  return true;
}

/// Step 4. Returns the number of flipped shells.
std::int64_t turnShells(TriangleMesh& m, const std::vector<Shell>& shells) {
  std::vector<std::size_t> order(shells.size());  // largest first
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double va = std::abs(shells[a].volume), vb = std::abs(shells[b].volume);
    return va != vb ? va > vb : a < b;
  });
  std::vector<char> decided(shells.size(), 0);
  std::int64_t turned = 0;
  const auto turnShell = [&](std::size_t s) {
    for (const std::uint32_t t : shells[s].triangles) turn(m, t);
    turned++;
  };
  for (std::size_t k = 0; k < order.size(); k++) {
    const Shell& outer = shells[order[k]];
    if (decided[order[k]]) continue;
    const bool wrong = outer.volume < 0 && outer.solid();
    // This shell is still undecided, so it lies in no larger shell. It decides for the shells within it.
    TriangleMesh part{m.vertices, {}};
    bool built = false;
    std::optional<TriangleBvh> tree;
    if (k < mostContainers && outer.solid())
      for (std::size_t j = k + 1; j < order.size(); j++) {
        const Shell& inner = shells[order[j]];
        bool within = !decided[order[j]] && inner.solid();
        for (int a = 0; a < 3; a++)
          within = within && inner.low[a] > outer.low[a] && inner.high[a] < outer.high[a];
        if (!within) continue;
        if (!built) {
          for (const std::uint32_t t : outer.triangles) part.triangles.push_back(m.triangles[t]);
          tree.emplace(part);
          built = true;
        }
        if (!contains(*tree, m, inner)) continue;
        decided[order[j]] = 1;
        if (wrong) turnShell(order[j]);
      }
    if (wrong) turnShell(order[k]);
  }
  return turned;
}

/// A mesh after steps 1 and 2.
struct Welded {
  TriangleMesh mesh;
  AlignedVector<EdgeSide> sides;
  std::size_t edges = 0, open = 0;
  Vec3d low{never, never, never}, high{-never, -never, -never};
};

Welded weldAndAgree(const TriangleMesh& mesh, MeshReport& report) {
  check(mesh);
  report = {};
  Welded w;
  TriangleMesh& m = w.mesh = weldVertices(mesh, 0);
  if (m.triangles.empty())
    throw ShapeError(
        "every triangle of the mesh has two equal corners; expected the closed surface of a solid");
  AlignedVector<EdgeSide>& sides = w.sides = edgeSides(m);
  w.open = openEdges(sides, w.edges);
  for (const Vec3d& v : m.vertices)
    for (int a = 0; a < 3; a++) w.low[a] = std::min(w.low[a], v[a]), w.high[a] = std::max(w.high[a], v[a]);
  if (w.open > 0) {
    TriangleMesh welded = weldVertices(m, weldTolerance * length(w.high - w.low));
    AlignedVector<EdgeSide> weldedSides = edgeSides(welded);
    std::size_t weldedEdges = 0;
    const std::size_t stillOpen = openEdges(weldedSides, weldedEdges);
    if (!welded.triangles.empty() && stillOpen < w.open)
      m = std::move(welded), sides = std::move(weldedSides), w.open = stillOpen, w.edges = weldedEdges;
  }
  report.triangles = static_cast<std::int64_t>(m.triangles.size());
  report.vertices = static_cast<std::int64_t>(m.vertices.size());
  report.closed = static_cast<double>(w.open) <= soupFraction * static_cast<double>(w.edges);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) { report.branched += last - first > 2; });
  report.turnedTriangles = orientPatches(m, sides);
  for (const auto& t : m.triangles) report.area += areaOf(m, t);
  return w;
}

/// Steps 3 to 5.
TriangleMesh closeMesh(Welded w, MeshReport& report) {
  TriangleMesh& m = w.mesh;
  if (report.closed) {
    report.holes = closeHoles(m, w.sides);
    if (report.holes > 0) w.sides = edgeSides(m);
    for (std::size_t t = static_cast<std::size_t>(report.triangles); t < m.triangles.size(); t++)
      report.holeArea += areaOf(m, m.triangles[t]);
    const std::vector<Shell> shells = findShells(m, w.sides);
    report.shells = static_cast<std::int64_t>(shells.size());
    report.turnedShells = turnShells(m, shells);
  }
  for (const auto& t : m.triangles) report.volume += volumeOf(m, t, 0.5 * (w.low + w.high));
  if (!report.closed && report.volume < 0) {
    for (std::size_t t = 0; t < m.triangles.size(); t++) turn(m, t);
    report.volume = -report.volume;
    report.turnedShells = 1;
  }
  if (!(report.volume > flat * std::pow(report.area, 1.5)))
    throw ShapeError("the mesh encloses no volume (its " + std::to_string(report.triangles) +
                     " triangles have " + std::to_string(w.open) + " open edges of " +
                     std::to_string(w.edges) + "); expected the closed surface of a solid");
  validateNormals(m, report);
  return std::move(m);
}

}  // namespace

TriangleMesh repairMesh(const TriangleMesh& mesh, MeshReport& report) {
  return closeMesh(weldAndAgree(mesh, report), report);
}

TriangleMesh repairSurface(const TriangleMesh& mesh, MeshReport& report) {
  Welded w = weldAndAgree(mesh, report);
  if (w.open == 0) return closeMesh(std::move(w), report);
  report.border = static_cast<std::int64_t>(w.open);
  report.closed = true;  // the inside of an open surface is not used
  validateNormals(w.mesh, report);
  return std::move(w.mesh);
}

std::string describeRepairs(const std::string& name, const MeshReport& r) {
  std::string s;
  const auto say = [&](const std::string& what) { s += (s.empty() ? "mesh '" + name + "': " : ", ") + what; };
  if (r.border > 0)
    say("open (" + std::to_string(r.border) + (r.border == 1 ? " edge" : " edges") +
        " at its border), kept open");
  if (!r.closed) say("not closed; inside is where the winding number is more than 1/2");
  if (r.holes > 0) {
    char share[32];
    std::snprintf(share, sizeof share, "%.3g", 100 * r.holeArea / r.area);
    say(std::to_string(r.holes) + (r.holes == 1 ? " hole closed (" : " holes closed (") + share +
        " % of the surface)");
  }
  if (r.branched > 0)
    say(std::to_string(r.branched) + (r.branched == 1 ? " edge has" : " edges have") +
        " more than two triangles");
  if (r.turnedTriangles > 0)
    say(std::to_string(r.turnedTriangles) + std::string(r.turnedTriangles == 1 ? " triangle" : " triangles") +
        " turned to agree with their neighbours");
  if (r.turnedShells > 0)
    say(std::to_string(r.turnedShells) + (r.turnedShells == 1 ? " shell" : " shells") +
        " turned the right side out");
  if (r.turnedNormals > 0) say(std::to_string(r.turnedNormals) + " normals turned outward");
  if (r.unusedNormals > 0)
    say(std::to_string(r.unusedNormals) + " of its " + std::to_string(r.normals) +
        " normals are missing, 0 or oppose their triangle; the normals of the "
        "triangles are used there");
  return s;
}

}  // namespace thaw
