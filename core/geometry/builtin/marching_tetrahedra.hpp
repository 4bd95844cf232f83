// SPDX-License-Identifier: Apache-2.0
// Marching tetrahedra (DK91): each cube has six tetrahedra around its diagonal (Kuhn), which
// match those of adjacent cubes.
#pragma once
#include <algorithm>
#include <utility>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Corners of a cube are numbered x + 2 y + 4 z. Each tetrahedron runs from corner 0 to corner 7 along three
/// edges, one per axis.
inline constexpr int kuhnTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                             {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

/// An edge between two corners of a cube, directed from the corner with fewer bits. All adjacent cubes see
/// the same edge.
struct CubeEdge {
  CubeEdge(int a, int b) : from(std::min(a, b)), to(std::max(a, b)) {}
  int from, to;
  int direction() const {
    return (from ^ to) - 1;
  }  ///< 0 to 6: number of the edge among those that begin at a corner
};

/// Smallest distance of a crossing from the ends of its edge, as a fraction of it, so that triangles do not
/// degenerate.
inline constexpr double nearestToCorner = 0.02;
/// Returns the position of the zero between the ends, as a fraction of the edge.
inline double crossing(double from, double to) {
  return std::clamp(from / (from - to), nearestToCorner, 1 - nearestToCorner);
}

/// Adds the triangles of the zero set within a cube to the mesh, outward. vertexOn(edge) returns the number
/// of the vertex on an edge. Triangles with equal vertices are left out. value < 0 inside.
template<class VertexOn> void marchCube(const double (&value)[8], VertexOn vertexOn, TriangleMesh& mesh) {
  const auto place = [](int c) {
    return Vec3d{static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1), static_cast<double>(c >> 2)};
  };
  for (const auto& tet : kuhnTetrahedra) {
    int in[4], out[4], inside = 0, outside = 0;
    for (const int c : tet) (value[c] < 0 ? in[inside++] : out[outside++]) = c;
    if (inside == 0 || outside == 0) continue;
    Vec3d outward;
    for (int k = 0; k < outside; k++) outward += place(out[k]) / static_cast<double>(outside);
    for (int k = 0; k < inside; k++) outward -= place(in[k]) / static_cast<double>(inside);
    const auto add = [&](const CubeEdge& e, const CubeEdge& f, const CubeEdge& g) {
      std::uint32_t a = vertexOn(e), b = vertexOn(f), c = vertexOn(g);
      if (a == b || b == c || c == a) return;
      const auto& x = mesh.vertices;
      if (dot(cross(x[b] - x[a], x[c] - x[a]), outward) < 0) std::swap(b, c);
      mesh.triangles.push_back({a, b, c});
    };
    if (inside == 2) {
      const CubeEdge a(in[0], out[0]), b(in[0], out[1]), c(in[1], out[1]), d(in[1], out[0]);
      add(a, b, c);
      add(a, c, d);
    } else if (inside == 1) {
      add(CubeEdge(in[0], out[0]), CubeEdge(in[0], out[1]), CubeEdge(in[0], out[2]));
    } else {
      add(CubeEdge(in[0], out[0]), CubeEdge(in[1], out[0]), CubeEdge(in[2], out[0]));
    }
  }
}

}  // namespace thaw
