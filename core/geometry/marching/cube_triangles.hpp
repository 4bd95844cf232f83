// SPDX-License-Identifier: Apache-2.0
// Triangles of the zero set within a cube (marching cubes, LC87), for closed meshes without shared edges.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace thaw {

/// Edge of a cube, from a corner along an axis. Corners have the numbers x + 2 y + 4 z.
struct AxisEdge {
  std::uint8_t from, axis;
  int to() const { return from | 1 << axis; }
  friend bool operator==(const AxisEdge&, const AxisEdge&) = default;
};

using CubeTriangles = std::vector<std::array<AxisEdge, 3>>;

/// Returns the triangles that separate corners inside from those outside. Their vertices lie on edges of the
/// cube, counter-clockwise seen from outside the body. On a face with two diagonally opposite inside corners,
/// these are separated, so adjacent cubes match. No edge of a triangle crosses such a face, since
/// triangles of the adjacent cube could have the same edge. inside: bit c for corner c.
const CubeTriangles& cubeTriangles(std::uint8_t inside);

/// Smallest distance of a crossing from the ends of its edge, as a fraction of the edge. It prevents
/// degenerate triangles.
inline constexpr double nearestToCorner = 0.02;
inline double awayFromCorners(double fraction) {
  return std::clamp(fraction, nearestToCorner, 1 - nearestToCorner);
}
/// Returns the position of the zero between the ends, as a fraction of the edge.
inline double crossing(double from, double to) { return awayFromCorners(from / (from - to)); }

/// Adds the triangles of a cube with these values at its corners, negative inside. vertexOn(edge) returns the
/// number of the vertex on an edge. Triangles with equal vertices are omitted.
template<class VertexOn>
void marchCube(const double (&value)[8], VertexOn vertexOn,
               std::vector<std::array<std::uint32_t, 3>>& triangles) {
  unsigned inside = 0;
  for (unsigned c = 0; c < 8; c++)
    if (value[c] < 0) inside |= 1u << c;
  for (const auto& t : cubeTriangles(static_cast<std::uint8_t>(inside))) {
    const std::uint32_t a = vertexOn(t[0]), b = vertexOn(t[1]), c = vertexOn(t[2]);
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  }
}

}  // namespace thaw
