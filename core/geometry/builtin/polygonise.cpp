// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/builtin/polygonise.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/builtin/marching_tetrahedra.hpp"

namespace thaw {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

struct Marcher {
  TriangleMesh mesh;
  std::size_t n[3];
  Vec3d origin;
  double spacing;
  std::vector<double> value;          // at the corners of the cubes
  std::vector<std::uint32_t> onEdge;  // vertex on the edge from a corner in each of 7 directions

  std::size_t corner(std::size_t i, std::size_t j, std::size_t k) const { return i + n[0] * (j + n[1] * k); }
  Vec3d place(std::size_t c) const {
    return origin + Vec3d{static_cast<double>(c % n[0]), static_cast<double>(c / n[0] % n[1]),
                          static_cast<double>(c / (n[0] * n[1]))} *
                        spacing;
  }

  std::uint32_t vertex(const std::size_t (&cube)[8], const CubeEdge& edge) {
    std::uint32_t& v = onEdge[cube[edge.from] * 7 + static_cast<std::size_t>(edge.direction())];
    if (v == none) {
      v = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec3d p = place(cube[edge.from]);
      mesh.vertices.push_back(p + (place(cube[edge.to]) - p) *
                                      crossing(value[cube[edge.from]], value[cube[edge.to]]));
    }
    return v;
  }

  void march(const std::size_t (&cube)[8]) {
    double at[8];
    for (int c = 0; c < 8; c++) at[c] = value[cube[c]];
    marchTetrahedra(at, [&](const CubeEdge& e, const CubeEdge& f, const CubeEdge& g, const Vec3d& outward) {
      std::uint32_t a = vertex(cube, e), b = vertex(cube, f), c = vertex(cube, g);
      const auto& v = mesh.vertices;
      if (dot(cross(v[b] - v[a], v[c] - v[a]), outward) < 0) std::swap(b, c);
      mesh.triangles.push_back({a, b, c});
    });
  }
};

}  // namespace

TriangleMesh polygonise(const std::function<double(const Vec3d&)>& value, const Bounds& bounds,
                        double spacing) {
  Marcher m;
  m.origin = bounds.min;
  m.spacing = spacing;
  for (int a = 0; a < 3; a++)
    m.n[a] = static_cast<std::size_t>(std::ceil((bounds.max[a] - bounds.min[a]) / spacing)) + 1;
  const std::size_t corners = m.n[0] * m.n[1] * m.n[2];
  m.value.resize(corners);
  m.onEdge.assign(corners * 7, none);
  for (std::size_t c = 0; c < corners; c++) m.value[c] = value(m.place(c));
  for (std::size_t k = 0; k + 1 < m.n[2]; k++)
    for (std::size_t j = 0; j + 1 < m.n[1]; j++)
      for (std::size_t i = 0; i + 1 < m.n[0]; i++) {
        std::size_t cube[8];
        int inside = 0;
        for (std::size_t c = 0; c < 8; c++) {
          cube[c] = m.corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
          inside += m.value[cube[c]] < 0;
        }
        if (inside == 0 || inside == 8) continue;
        m.march(cube);
      }
  return m.mesh;
}

}  // namespace thaw
