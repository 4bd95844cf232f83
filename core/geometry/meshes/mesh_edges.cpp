// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/mesh_edges.hpp"

#include <algorithm>

namespace thaw {

AlignedVector<EdgeSide> edgeSides(const TriangleMesh& mesh) {
  // Sorts by the smaller vertex into buckets in one pass, since few sides share a vertex.
  std::vector<std::uint32_t> next(mesh.vertices.size() + 1, 0);
  const auto forEachSide = [&](auto&& f) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
      for (std::size_t k = 0; k < 3; k++) {
        const std::uint64_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        f(a < b ? EdgeSide{a << 32 | b, t, 1} : EdgeSide{b << 32 | a, t, -1});
      }
  };
  forEachSide([&](const EdgeSide& s) { next[(s.edge >> 32) + 1]++; });
  for (std::size_t v = 1; v < next.size(); v++) next[v] += next[v - 1];
  AlignedVector<EdgeSide> sides(mesh.triangles.size() * 3);
  forEachSide([&](const EdgeSide& s) { sides[next[s.edge >> 32]++] = s; });
  std::uint32_t first = 0;
  for (std::size_t v = 0; v + 1 < next.size(); v++) {
    std::sort(sides.begin() + first, sides.begin() + next[v], [](const EdgeSide& p, const EdgeSide& q) {
      return p.edge != q.edge ? p.edge < q.edge : p.triangle < q.triangle;
    });
    first = next[v];
  }
  return sides;
}

}  // namespace thaw
