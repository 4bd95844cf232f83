#include "core/geometry/polygonise.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

/// Corners of a cube are numbered x + 2 y + 4 z. Each tetrahedron goes from corner 0 to 7 along three edges, one of each axis.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};
constexpr std::uint32_t none = 0xffffffffu;
constexpr double nearestToCorner = 0.02;  // of an edge: keeps triangles from degenerating

struct Marcher {
  TriangleMesh mesh;
  std::size_t n[3];
  Vec3d origin;
  double spacing;
  std::vector<double> value;          // at the corners of the cubes
  std::vector<std::uint32_t> onEdge;  // vertex on the edge from a corner in each of 7 directions

  std::size_t corner(std::size_t i, std::size_t j, std::size_t k) const { return i + n[0] * (j + n[1] * k); }
  Vec3d place(std::size_t c) const {
    return origin + Vec3d{static_cast<double>(c % n[0]), static_cast<double>(c / n[0] % n[1]), static_cast<double>(c / (n[0] * n[1]))} * spacing;
  }

  std::uint32_t vertex(const std::size_t (&cube)[8], int a, int b) {
    if (a > b) std::swap(a, b);  // along the diagonal every edge goes from fewer to more bits
    std::uint32_t& v = onEdge[cube[a] * 7 + static_cast<std::size_t>(b ^ a) - 1];
    if (v == none) {
      v = static_cast<std::uint32_t>(mesh.vertices.size());
      const double va = value[cube[a]], vb = value[cube[b]], t = std::clamp(va / (va - vb), nearestToCorner, 1 - nearestToCorner);
      const Vec3d p = place(cube[a]);
      mesh.vertices.push_back(p + (place(cube[b]) - p) * t);
    }
    return v;
  }

  /// Adds a triangle that looks along `outward`.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3d& outward) {
    const auto& v = mesh.vertices;
    if (dot(cross(v[b] - v[a], v[c] - v[a]), outward) < 0) std::swap(b, c);
    mesh.triangles.push_back({a, b, c});
  }

  void march(const std::size_t (&cube)[8], const int (&tet)[4]) {
    int in[4], out[4], inside = 0, outside = 0;
    Vec3d outward;
    for (const int c : tet) {
      const bool isIn = value[cube[c]] < 0;
      (isIn ? in[inside++] : out[outside++]) = c;
    }
    if (inside == 0 || outside == 0) return;
    for (int k = 0; k < outside; k++) outward += place(cube[out[k]]) / static_cast<double>(outside);
    for (int k = 0; k < inside; k++) outward -= place(cube[in[k]]) / static_cast<double>(inside);
    if (inside == 2) {
      const std::uint32_t a = vertex(cube, in[0], out[0]), b = vertex(cube, in[0], out[1]), c = vertex(cube, in[1], out[1]), d = vertex(cube, in[1], out[0]);
      add(a, b, c, outward);
      add(a, c, d, outward);
    } else if (inside == 1) {
      add(vertex(cube, in[0], out[0]), vertex(cube, in[0], out[1]), vertex(cube, in[0], out[2]), outward);
    } else {
      add(vertex(cube, in[0], out[0]), vertex(cube, in[1], out[0]), vertex(cube, in[2], out[0]), outward);
    }
  }
};

}  // namespace

TriangleMesh polygonise(const std::function<double(const Vec3d&)>& value, const Bounds& bounds, double spacing) {
  Marcher m;
  m.origin = bounds.min;
  m.spacing = spacing;
  for (int a = 0; a < 3; a++) m.n[a] = static_cast<std::size_t>(std::ceil((bounds.max[a] - bounds.min[a]) / spacing)) + 1;
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
        for (const auto& tet : tetrahedra) m.march(cube, tet);
      }
  return m.mesh;
}

}  // namespace thaw
