// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/offset_vertices.hpp"

#include <algorithm>

namespace thaw {

void offsetVertices(MarchedBand& band, double most) {
  ComponentMesh& m = band.mesh;
  std::vector<Vec3d>& vertices = m.mesh.vertices;
  std::vector<double> area(vertices.size()), bulge(vertices.size());
  const auto normal = [&](std::uint32_t v) { return Vec3d{m.normals[v].x, m.normals[v].y, m.normals[v].z}; };
  for (const auto& t : m.mesh.triangles) {
    const int fixedAxes = band.fixedAxes[t[0]] & band.fixedAxes[t[1]] & band.fixedAxes[t[2]];
    if (fixedAxes != 0) continue;  // flat, on a cut
    double height = 0;
    for (std::size_t k = 0; k < 3; k++)
      height += dot(vertices[t[(k + 1) % 3]] - vertices[t[k]], normal(t[(k + 1) % 3]) - normal(t[k])) / 24;
    const double size = length(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
    for (const std::uint32_t v : t) area[v] += size, bulge[v] += size * height;
  }
  for (std::uint32_t v = 0; v < vertices.size(); v++)
    if (area[v] > 0 && !(band.fixedAxes[v] & MarchedBand::onCap)) {
      Vec3d move = std::clamp(bulge[v] / area[v], -most, most) * normal(v);
      for (int a = 0; a < 3; a++)
        if (band.fixedAxes[v] >> a & 1) move[a] = 0;
      vertices[v] += move;
    }
}

}  // namespace thaw
