// SPDX-License-Identifier: Apache-2.0
// Small meshes for tests.
#pragma once
#include <algorithm>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/marching/polygonise.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {

/// A closed box of 12 outward triangles.
inline TriangleMesh boxMesh(const Vec3d& low, const Vec3d& high) {
  TriangleMesh m;
  for (int c = 0; c < 8; c++)
    m.vertices.push_back({c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z});
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

inline TriangleMesh ballMesh(const Vec3d& centre, double radius, double spacing) {
  const Vec3d r{radius + 1.5 * spacing, radius + 1.5 * spacing, radius + 1.5 * spacing};
  return polygonise([&](const Vec3d& x) { return length(x - centre) - radius; }, {centre - r, centre + r},
                    spacing);
}

inline void append(TriangleMesh& m, const TriangleMesh& more) {
  const auto n = static_cast<std::uint32_t>(m.vertices.size());
  m.vertices.insert(m.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles) m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
}

inline void turnAll(TriangleMesh& m) {
  for (auto& t : m.triangles) std::swap(t[1], t[2]);
}

inline double volumeOf(const TriangleMesh& m) {
  double v = 0;
  for (const auto& t : m.triangles) v += dot(m.vertices[t[0]], cross(m.vertices[t[1]], m.vertices[t[2]])) / 6;
  return v;
}

/// Random point of a box.
inline Vec3d randomPoint(const Bounds& b, std::uint64_t id) {
  Vec3d x;
  for (int a = 0; a < 3; a++)
    x[a] = b.min[a] +
           (b.max[a] - b.min[a]) * randomUniform(11, Purpose::Test, id, static_cast<std::uint64_t>(a));
  return x;
}

/// Winding number as the sum over all triangles.
inline double bruteWinding(const TriangleMesh& m, const Vec3d& x) {
  double w = 0;
  for (const auto& t : m.triangles)
    w += windingOfTriangle(m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]], x);
  return w;
}

inline double bruteDistance(const TriangleMesh& m, const Vec3d& x) {
  double d = never;
  for (const auto& t : m.triangles)
    d = std::min(d,
                 length(x - closestPointOfTriangle(m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]], x)));
  return d;
}

}  // namespace thaw
