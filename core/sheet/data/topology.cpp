// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/topology.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/meshes/mesh_edges.hpp"

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
      throw ShapeError("adjacent triangles of a sheet must face the same side; those at the edge between " +
                       corners(sides[first].edge) + " do not");
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
  // Open fans first, each from its first border; then closed rings, from their smallest neighbour.
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

}  // namespace

SheetTopology sheetTopology(const TriangleMesh& mesh) {
  SheetTopology t;
  const std::size_t n = mesh.vertices.size();
  if (mesh.triangles.empty()) throw ShapeError("a sheet's mesh has no triangles; expected at least one");
  t.area.assign(n, 0);
  std::vector<std::uint32_t> first(n + 1, 0);
  std::vector<double> areas;
  for (const auto& tri : mesh.triangles) {
    for (const std::uint32_t v : tri) {
      if (v >= n)
        throw ShapeError("a triangle of a sheet's mesh names vertex " + std::to_string(v) + " of " +
                         std::to_string(n));
      first[v + 1]++;
    }
    const Vec3d& a = mesh.vertices[tri[0]];
    areas.push_back(0.5 * length(cross(mesh.vertices[tri[1]] - a, mesh.vertices[tri[2]] - a)));
    if (!(areas.back() > 0))
      throw ShapeError("triangle " + std::to_string(areas.size() - 1) + " of a sheet's mesh has no area");
  }
  for (std::size_t v = 0; v < n; v++) {
    if (first[v + 1] == 0)
      throw ShapeError("vertex " + std::to_string(v) + " of a sheet's mesh has no triangle");
    first[v + 1] += first[v];
  }
  const AlignedVector<EdgeSide> sides = edgeSides(mesh);
  checkEdges(sides);

  std::vector<Corner> all(3 * mesh.triangles.size());
  std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
  for (std::size_t k = 0; k < mesh.triangles.size(); k++)
    for (std::size_t c = 0; c < 3; c++) {
      const auto& tri = mesh.triangles[k];
      all[at[tri[c]]++] = {tri[(c + 1) % 3], tri[(c + 2) % 3], areas[k]};
      t.area[tri[c]] += areas[k] / 3;
    }
  std::vector<Corner> own;
  t.first.push_back(0);
  for (std::size_t v = 0; v < n; v++) {
    own.assign(all.begin() + first[v], all.begin() + first[v + 1]);
    addFans(own, t.ring);
    if (t.ring.size() - t.first.back() > 60000)
      throw ShapeError("vertex " + std::to_string(v) + " of a sheet's mesh has too many neighbours");
    t.first.push_back(static_cast<std::uint32_t>(t.ring.size()));
  }

  DisjointSets sets(n);
  for (const EdgeSide& s : sides)
    sets.join(static_cast<std::uint32_t>(s.edge >> 32), static_cast<std::uint32_t>(s.edge & 0xffffffffu));
  std::vector<std::uint32_t> number(n, noVertex);
  for (std::uint32_t v = 0; v < n; v++) {
    const std::uint32_t root = sets.find(v);
    if (number[root] == noVertex) {
      number[root] = static_cast<std::uint32_t>(t.closed.size());
      t.closed.push_back(1);
    }
    t.component.push_back(number[root]);
  }
  const auto third = [&](std::uint32_t triangle, std::uint32_t a, std::uint32_t b) {
    for (const std::uint32_t v : mesh.triangles[triangle])
      if (v != a && v != b) return v;
    return noVertex;
  };
  forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    const auto a = static_cast<std::uint32_t>(sides[begin].edge >> 32),
               b = static_cast<std::uint32_t>(sides[begin].edge & 0xffffffffu);
    if (end - begin < 2) {
      t.closed[t.component[a]] = 0;
      return;
    }
    const std::uint32_t c = third(sides[begin].triangle, a, b), d = third(sides[begin + 1].triangle, a, b);
    t.hinges.push_back({a, b, std::min(c, d), std::max(c, d)});
  });
  t.volume.assign(t.closed.size(), 0);
  std::vector<Vec3d> origin(t.closed.size());
  for (std::size_t v = n; v-- > 0;) origin[t.component[v]] = mesh.vertices[v];
  for (const auto& tri : mesh.triangles) {
    const std::uint32_t c = t.component[tri[0]];
    t.volume[c] += dot(mesh.vertices[tri[0]] - origin[c],
                       cross(mesh.vertices[tri[1]] - origin[c], mesh.vertices[tri[2]] - origin[c])) /
                   6;
  }
  for (std::size_t c = 0; c < t.closed.size(); c++)
    if (!t.closed[c]) t.volume[c] = 0;
  return t;
}

}  // namespace thaw
