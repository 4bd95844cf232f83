#include "core/geometry/mesh_edges.hpp"

#include <algorithm>

namespace thaw {

std::vector<EdgeSide> edgeSides(const TriangleMesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(mesh.triangles.size() * 3);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint64_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back(a < b ? EdgeSide{a << 32 | b, t, 1} : EdgeSide{b << 32 | a, t, -1});
    }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& p, const EdgeSide& q) {
    return p.edge != q.edge ? p.edge < q.edge : p.triangle < q.triangle;
  });
  return sides;
}

}  // namespace thaw
