// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/cube_triangles.hpp"

#include <bit>
#include <cstddef>
#include <span>

namespace thaw {

namespace {

/// Corners of each face, counter-clockwise seen from outside the cube.
constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
constexpr std::size_t edgeCount = 24;  // numbers of edges: 8 axis + first corner

std::size_t numberOf(int a, int b) {
  const int axis = std::countr_zero(static_cast<unsigned>(a ^ b));
  return 8 * static_cast<std::size_t>(axis) + static_cast<std::size_t>(a & b);
}
AxisEdge edgeOf(std::size_t number) {
  return {static_cast<std::uint8_t>(number % 8), static_cast<std::uint8_t>(number / 8)};
}

bool onFace(std::size_t edge, const int (&face)[4]) {
  const AxisEdge e = edgeOf(edge);
  bool from = false, to = false;
  for (const int corner : face) from = from || corner == e.from, to = to || corner == e.to();
  return from && to;
}
bool shareFace(std::size_t a, std::size_t b) {
  for (const auto& face : faces)
    if (onFace(a, face) && onFace(b, face)) return true;
  return false;
}

using Polygon = std::vector<std::size_t>;

/// Returns the polygons between inside and outside. On each face, a side of a polygon separates a run of
/// inside corners. It leads from the edge before the run to the edge after it.
std::vector<Polygon> polygonsOf(std::uint8_t inside) {
  constexpr std::size_t none = edgeCount;
  std::array<std::size_t, edgeCount> next;
  next.fill(none);
  const auto isInside = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (const auto& face : faces)
    for (int k = 0; k < 4; k++) {
      const int before = face[(k + 3) % 4], first = face[k];
      if (isInside(before) || !isInside(first)) continue;
      int last = k;
      while (isInside(face[(last + 1) % 4])) last++;
      next[numberOf(before, first)] = numberOf(face[last % 4], face[(last + 1) % 4]);
    }
  std::vector<Polygon> all;
  for (std::size_t start = 0; start < edgeCount; start++) {
    if (next[start] == none) continue;
    all.emplace_back();
    for (std::size_t at = start; next[at] != none;) {
      all.back().push_back(at);
      const std::size_t to = next[at];
      next[at] = none;
      at = to;
    }
  }
  return all;
}

/// Adds the triangles of a polygon. Returns false, without a change, if every triangulation has a diagonal on
/// a face.
bool addTriangles(std::span<const std::size_t> polygon, CubeTriangles& to) {
  const std::size_t n = polygon.size(), before = to.size();
  if (n < 3) return true;
  const auto allowed = [&](std::size_t i, std::size_t j) {
    return j == i + 1 || (i == 0 && j == n - 1) || !shareFace(polygon[i], polygon[j]);
  };
  for (std::size_t k = 1; k + 1 < n; k++) {  // corner of the triangle at the side from last to first
    if (!allowed(0, k) || !allowed(k, n - 1)) continue;
    to.push_back({edgeOf(polygon[0]), edgeOf(polygon[k]), edgeOf(polygon[n - 1])});
    if (addTriangles(polygon.first(k + 1), to) && addTriangles(polygon.subspan(k), to)) return true;
    to.resize(before);
  }
  return false;
}

std::array<CubeTriangles, 256> allCases() {
  std::array<CubeTriangles, 256> all;
  for (std::size_t inside = 0; inside < all.size(); inside++)
    for (const Polygon& polygon : polygonsOf(static_cast<std::uint8_t>(inside)))
      addTriangles(polygon, all[inside]);
  return all;
}

}  // namespace

const CubeTriangles& cubeTriangles(std::uint8_t inside) {
  static const std::array<CubeTriangles, 256> cases = allCases();
  return cases[inside];
}

}  // namespace thaw
