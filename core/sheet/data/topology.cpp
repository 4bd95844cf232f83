// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/topology.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/meshes/mesh_edges.hpp"
#include "core/math/disjoint_sets.hpp"

namespace thaw {
namespace {

std::string corners(std::uint64_t edge) {
  return "vertices " + std::to_string(edge >> 32) + " and " + std::to_string(edge & 0xffffffffu);
}

void checkEdges(const AlignedVector<EdgeSide>& sides) {
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first > 2)
      throw ShapeError("an edge of a sheet may have at most two triangles; the edge between " +
                       corners(sides[first].edge) + " has " + std::to_string(last - first));
    if (last - first == 2 && sides[first].sign == sides[first + 1].sign)
      throw ShapeError("the triangles of a sheet at the edge between " + corners(sides[first].edge) +
                       " have opposite winding; expected one orientation");
  });
}

/// One triangle at a vertex, counter-clockwise from neighbour `from` to neighbour `to`.
struct Corner {
  std::uint32_t from, to;
  double area;
};

void addFans(std::vector<Corner>& corners, std::vector<RingEdge>& ring) {
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.from < b.from; });
  const auto startingAt = [&](std::uint32_t v) {
    const auto at = std::lower_bound(corners.begin(), corners.end(), v,
                                     [](const Corner& c, std::uint32_t x) { return c.from < x; });
    return at != corners.end() && at->from == v ? static_cast<std::size_t>(at - corners.begin())
                                                : corners.size();
  };
  std::vector<std::uint8_t> used(corners.size(), 0), entered(corners.size(), 0);
  for (const Corner& c : corners)
    if (const std::size_t next = startingAt(c.to); next < corners.size()) entered[next] = 1;
  const std::size_t begin = ring.size();
  // Open fans are first, each from its first border. Closed rings follow, from their smallest neighbour.
  for (const bool open : {true, false})
    for (std::size_t k = 0; k < corners.size(); k++) {
      if (used[k] || (open && entered[k])) continue;
      const std::size_t fan = ring.size();
      double before = 0;
      std::size_t at = k;
      while (at < corners.size() && !used[at]) {
        used[at] = 1;
        ring.push_back({corners[at].from, true, static_cast<std::uint16_t>(ring.size() - begin + 1),
                        before + corners[at].area});
        before = corners[at].area;
        const std::uint32_t to = corners[at].to;
        at = startingAt(to);
        if (at == corners.size()) ring.push_back({to, false, 0, before});
      }
      if (at < corners.size()) {  // closed ring: the last triangle joins the first
        ring.back().next = static_cast<std::uint16_t>(fan - begin);
        ring[fan].area += before;
      }
    }
}

/// Returns the area (m^2) of each triangle. Throws ShapeError for triangles without area and vertices that do
/// not exist or have no triangle.
std::vector<double> triangleAreas(const TriangleMesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  std::vector<std::uint8_t> used(n, 0);
  std::vector<double> areas;
  for (const auto& tri : mesh.triangles) {
    for (const std::uint32_t v : tri) {
      if (v >= n)
        throw ShapeError("triangle " + std::to_string(areas.size()) + " of a sheet's mesh refers to vertex " +
                         std::to_string(v) + ", but the mesh has " + std::to_string(n) + " (0 to " +
                         std::to_string(n - 1) + ")");
      used[v] = 1;
    }
    const Vec3d& a = mesh.vertices[tri[0]];
    areas.push_back(0.5 * length(cross(mesh.vertices[tri[1]] - a, mesh.vertices[tri[2]] - a)));
    if (!(areas.back() > 0))
      throw ShapeError("triangle " + std::to_string(areas.size() - 1) + " of a sheet's mesh has no area");
  }
  for (std::size_t v = 0; v < n; v++)
    if (!used[v]) throw ShapeError("vertex " + std::to_string(v) + " of a sheet's mesh has no triangle");
  return areas;
}

/// Triangles at each vertex: the triangles of vertex v are corner[first[v]] up to corner[first[v + 1]],
/// excluded.
struct VertexCorners {
  std::vector<std::uint32_t> first;
  std::vector<Corner> corner;
};

VertexCorners cornersOf(const TriangleMesh& mesh, const std::vector<double>& areas) {
  VertexCorners c;
  c.first.assign(mesh.vertices.size() + 1, 0);
  for (const auto& tri : mesh.triangles)
    for (const std::uint32_t v : tri) c.first[v + 1]++;
  for (std::size_t v = 0; v + 1 < c.first.size(); v++) c.first[v + 1] += c.first[v];
  c.corner.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> at(c.first.begin(), c.first.end() - 1);
  for (std::size_t k = 0; k < mesh.triangles.size(); k++)
    for (std::size_t q = 0; q < 3; q++) {
      const auto& tri = mesh.triangles[k];
      c.corner[at[tri[q]]++] = {tri[(q + 1) % 3], tri[(q + 2) % 3], areas[k]};
    }
  return c;
}

void addRings(const VertexCorners& corners, SheetTopology& t) {
  constexpr std::size_t mostNeighbours = 60000;  // RingEdge::next has 16 bits
  std::vector<Corner> own;
  t.first.push_back(0);
  for (std::size_t v = 0; v + 1 < corners.first.size(); v++) {
    own.assign(corners.corner.begin() + corners.first[v], corners.corner.begin() + corners.first[v + 1]);
    addFans(own, t.ring);
    if (t.ring.size() - t.first.back() > mostNeighbours)
      throw ShapeError("vertex " + std::to_string(v) + " of a sheet's mesh has too many neighbours");
    t.first.push_back(static_cast<std::uint32_t>(t.ring.size()));
  }
}

std::uint32_t lowVertex(std::uint64_t edge) { return static_cast<std::uint32_t>(edge >> 32); }
std::uint32_t highVertex(std::uint64_t edge) { return static_cast<std::uint32_t>(edge & 0xffffffffu); }

/// Numbers components by their first vertices.
void addComponents(const AlignedVector<EdgeSide>& sides, std::size_t vertices, SheetTopology& t) {
  DisjointSets sets(vertices);
  for (const EdgeSide& s : sides) sets.join(lowVertex(s.edge), highVertex(s.edge));
  std::vector<std::uint32_t> number(vertices, noVertex);
  for (std::uint32_t v = 0; v < vertices; v++) {
    const std::uint32_t root = sets.find(v);
    if (number[root] == noVertex) {
      number[root] = static_cast<std::uint32_t>(t.closed.size());
      t.closed.push_back(1);
    }
    t.component.push_back(number[root]);
  }
}

/// Adds a hinge for each inner edge, and marks components with a border as not closed.
void addHinges(const TriangleMesh& mesh, const AlignedVector<EdgeSide>& sides, SheetTopology& t) {
  const auto across = [&](std::uint32_t triangle, std::uint32_t a, std::uint32_t b) {
    for (const std::uint32_t v : mesh.triangles[triangle])
      if (v != a && v != b) return v;
    return noVertex;
  };
  forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    const std::uint32_t a = lowVertex(sides[begin].edge), b = highVertex(sides[begin].edge);
    if (end - begin < 2) {
      t.closed[t.component[a]] = 0;
      return;
    }
    const std::uint32_t c = across(sides[begin].triangle, a, b), d = across(sides[begin + 1].triangle, a, b);
    t.hinges.push_back({a, b, std::min(c, d), std::max(c, d)});
  });
}

/// Sums the volumes of tetrahedra from the first vertex of each closed component.
void addVolumes(const TriangleMesh& mesh, SheetTopology& t) {
  t.volume.assign(t.closed.size(), 0);
  std::vector<Vec3d> origin(t.closed.size());
  for (std::size_t v = mesh.vertices.size(); v-- > 0;) origin[t.component[v]] = mesh.vertices[v];
  for (const auto& tri : mesh.triangles) {
    const std::uint32_t c = t.component[tri[0]];
    t.volume[c] += dot(mesh.vertices[tri[0]] - origin[c],
                       cross(mesh.vertices[tri[1]] - origin[c], mesh.vertices[tri[2]] - origin[c])) /
                   6;
  }
  for (std::size_t c = 0; c < t.closed.size(); c++)
    if (!t.closed[c]) t.volume[c] = 0;
}

}  // namespace

SheetTopology sheetTopology(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw ShapeError("a sheet's mesh has no triangles; expected at least one");
  const std::vector<double> areas = triangleAreas(mesh);
  const AlignedVector<EdgeSide> sides = edgeSides(mesh);
  checkEdges(sides);
  SheetTopology t;
  t.area.assign(mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < mesh.triangles.size(); k++)
    for (const std::uint32_t v : mesh.triangles[k]) t.area[v] += areas[k] / 3;
  addRings(cornersOf(mesh, areas), t);
  addComponents(sides, mesh.vertices.size(), t);
  addHinges(mesh, sides, t);
  addVolumes(mesh, t);
  return t;
}

}  // namespace thaw
