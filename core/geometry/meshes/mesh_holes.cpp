// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/mesh_holes.hpp"

#include <algorithm>

namespace thaw {
namespace {

struct BorderEdge {
  std::uint32_t from, to;
};

/// Returns the directed edges that the mesh lacks to be balanced.
std::vector<BorderEdge> lackingEdges(const AlignedVector<EdgeSide>& sides) {
  std::vector<BorderEdge> border;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    int net = 0;
    for (std::size_t k = first; k < last; k++) net += sides[k].sign;
    const auto a = static_cast<std::uint32_t>(sides[first].edge >> 32),
               b = static_cast<std::uint32_t>(sides[first].edge);
    for (; net > 0; net--) border.push_back({b, a});
    for (; net < 0; net++) border.push_back({a, b});
  });
  std::sort(border.begin(), border.end(),
            [](BorderEdge p, BorderEdge q) { return p.from != q.from ? p.from < q.from : p.to < q.to; });
  return border;
}

void closeLoop(TriangleMesh& mesh, const std::vector<std::uint32_t>& loop) {
  if (loop.size() == 3) {
    mesh.triangles.push_back({loop[0], loop[1], loop[2]});
    return;
  }
  Vec3d middle;
  for (const std::uint32_t v : loop) middle += mesh.vertices[v];
  const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(middle / static_cast<double>(loop.size()));
  if (!mesh.colours.empty()) mesh.colours.push_back(mesh.colours[loop[0]]);
  for (std::size_t k = 0; k < loop.size(); k++)
    mesh.triangles.push_back({loop[k], loop[(k + 1) % loop.size()], m});
}

}  // namespace

std::int64_t closeHoles(TriangleMesh& mesh, const AlignedVector<EdgeSide>& sides) {
  const std::vector<BorderEdge> border = lackingEdges(sides);
  if (border.empty()) return 0;
  const std::size_t vertices = mesh.vertices.size();
  std::vector<std::uint32_t> next(vertices + 1, 0);  // first unused edge of each vertex
  for (const BorderEdge& e : border) next[e.from + 1]++;
  for (std::size_t v = 0; v < vertices; v++) next[v + 1] += next[v];
  const std::vector<std::uint32_t> begin(next);
  std::vector<std::uint32_t> placeOnPath(vertices, 0);  // 1 + index
  std::int64_t holes = 0;
  std::vector<std::uint32_t> path;
  for (std::uint32_t start = 0; start < vertices; start++) {
    // The numbers of border edges that leave and enter a vertex are equal, so a walk ends only at its start.
    // If the walk crosses itself, the enclosed loop is a separate hole.
    while (next[start] < begin[start + 1]) {
      path.assign(1, start);
      placeOnPath[start] = 1;
      while (!path.empty()) {
        const std::uint32_t v = path.back();
        if (next[v] == begin[v + 1]) break;
        const std::uint32_t to = border[next[v]++].to;
        if (placeOnPath[to] == 0) {
          path.push_back(to);
          placeOnPath[to] = static_cast<std::uint32_t>(path.size());
          continue;
        }
        const std::vector<std::uint32_t> loop(path.begin() + placeOnPath[to] - 1, path.end());
        for (std::size_t k = placeOnPath[to]; k < path.size(); k++) placeOnPath[path[k]] = 0;
        path.resize(placeOnPath[to]);
        if (loop.size() > 2) {  // a path back and forth along one edge encloses nothing
          closeLoop(mesh, loop);
          holes++;
        }
      }
      for (const std::uint32_t v : path) placeOnPath[v] = 0;
    }
  }
  if (!mesh.normals.empty()) mesh.normals.resize(mesh.triangles.size());
  return holes;
}

}  // namespace thaw
