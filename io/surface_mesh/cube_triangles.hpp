// SPDX-License-Identifier: Apache-2.0
// Triangles of the zero set within a cube (marching cubes, LC87), for closed meshes without shared edges.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace thaw {

/// Edge of a cube from a corner along an axis. Corners are numbered x + 2 y + 4 z.
struct AxisEdge {
  std::uint8_t from, axis;
  int to() const { return from | 1 << axis; }
  friend bool operator==(const AxisEdge&, const AxisEdge&) = default;
};

using CubeTriangles = std::vector<std::array<AxisEdge, 3>>;

/// Returns the triangles that separate corners inside from those outside. Their vertices lie on edges of the
/// cube, counter-clockwise seen from outside the body. On a face with two diagonal corners inside, the two
/// are separated, so cubes match. No edge of a triangle crosses such a face, since the triangles of the other
/// cube could have the same edge. inside: bit c for corner c.
const CubeTriangles& cubeTriangles(std::uint8_t inside);

}  // namespace thaw
