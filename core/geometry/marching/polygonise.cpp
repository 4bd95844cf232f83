// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/polygonise.hpp"

#include <cmath>
#include <unordered_map>

#include "core/geometry/marching/cube_triangles.hpp"

namespace thaw {

TriangleMesh polygonise(const std::function<double(const Vec3d&)>& value, const Bounds& bounds,
                        double spacing) {
  std::size_t n[3];
  for (int a = 0; a < 3; a++)
    n[a] = static_cast<std::size_t>(std::ceil((bounds.max[a] - bounds.min[a]) / spacing)) + 1;
  const auto place = [&](std::size_t c) {
    return bounds.min + Vec3d{static_cast<double>(c % n[0]), static_cast<double>(c / n[0] % n[1]),
                              static_cast<double>(c / (n[0] * n[1]))} *
                            spacing;
  };
  std::vector<double> values(n[0] * n[1] * n[2]);
  for (std::size_t c = 0; c < values.size(); c++) values[c] = value(place(c));
  TriangleMesh mesh;
  std::unordered_map<std::size_t, std::uint32_t> onEdge;  // by first corner and axis
  for (std::size_t k = 0; k + 1 < n[2]; k++)
    for (std::size_t j = 0; j + 1 < n[1]; j++)
      for (std::size_t i = 0; i + 1 < n[0]; i++) {
        std::size_t corner[8];
        double at[8];
        for (std::size_t c = 0; c < 8; c++) {
          corner[c] = i + (c & 1) + n[0] * (j + (c >> 1 & 1) + n[1] * (k + (c >> 2)));
          at[c] = values[corner[c]];
        }
        const auto vertexOn = [&](const AxisEdge& e) {
          const std::size_t from = corner[e.from], to = corner[e.to()];
          const auto [vertex, fresh] = onEdge.try_emplace(3 * from + e.axis,
                                                          static_cast<std::uint32_t>(mesh.vertices.size()));
          const Vec3d p = place(from);
          if (fresh) mesh.vertices.push_back(p + (place(to) - p) * crossing(values[from], values[to]));
          return vertex->second;
        };
        marchCube(at, vertexOn, mesh.triangles);
      }
  return mesh;
}

}  // namespace thaw
