// SPDX-License-Identifier: Apache-2.0
// Counts crossings of sheets with each other or themselves, from their meshes alone.
#pragma once
#include <map>
#include <set>

#include "tests/support/simulation.hpp"

namespace thaw::test {

/// Six times the volume of a tetrahedron; exactly 0 below rounding.
inline double volumeOf(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d u = b - a, v = c - a, w = d - a;
  const double six = dot(cross(u, v), w);
  return std::abs(six) > 1e-12 * length(u) * length(v) * length(w) ? six : 0;
}

/// Positions of all vertices of a sheet by number. Vertices that have left keep their initial positions.
inline std::vector<Vec3d> verticesOf(const World& w, std::size_t sheet) {
  std::vector<Vec3d> x = w.sheets.plans[sheet].mesh.vertices;
  const Sheets& s = w.sheets.rows;
  for (std::size_t i = 0; i < s.owned; i++)
    if (s.body[i] == sheet) x[s.id[i] & ((1ull << 40) - 1)] = s.position[i];
  return x;
}

/// Counts crossing pairs of an edge of one sheet and a triangle of another, or of the same sheet without a
/// common vertex.
inline int countCrossings(const World& w, std::size_t one, std::size_t other) {
  const auto &a = w.sheets.plans[one].mesh.triangles, &b = w.sheets.plans[other].mesh.triangles;
  const std::vector<Vec3d> x = verticesOf(w, one), y = verticesOf(w, other);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  double longest = 0;
  for (const auto& t : a)
    for (std::size_t k = 0; k < 3; k++) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  for (const auto& [p, q] : edges) longest = std::max(longest, length(x[p] - x[q]));
  for (const auto& t : b)
    for (std::size_t k = 0; k < 3; k++) longest = std::max(longest, length(y[t[k]] - y[t[(k + 1) % 3]]));
  const auto cube = [&](const Vec3d& at) {
    return std::array<long, 3>{std::lround(at.x / longest), std::lround(at.y / longest),
                               std::lround(at.z / longest)};
  };
  std::map<std::array<long, 3>, std::vector<std::size_t>> near;  // triangles by the cube of their first
                                                                 // corner
  for (std::size_t k = 0; k < b.size(); k++) near[cube(y[b[k][0]])].push_back(k);
  int crossings = 0;
  for (const auto& [p, q] : edges) {
    const auto middle = cube(0.5 * (x[p] + x[q]));
    for (long i = -2; i <= 2; i++)
      for (long j = -2; j <= 2; j++)
        for (long k = -2; k <= 2; k++) {
          const auto at = near.find({middle[0] + i, middle[1] + j, middle[2] + k});
          if (at == near.end()) continue;
          for (const std::size_t n : at->second) {
            const auto& t = b[n];
            if (one == other && (t[0] == p || t[1] == p || t[2] == p || t[0] == q || t[1] == q || t[2] == q))
              continue;
            const Vec3d &c = y[t[0]], &d = y[t[1]], &e = y[t[2]];
            if (!(volumeOf(c, d, e, x[p]) * volumeOf(c, d, e, x[q]) < 0)) continue;
            const double u = volumeOf(x[p], x[q], c, d), v = volumeOf(x[p], x[q], d, e),
                         r = volumeOf(x[p], x[q], e, c);
            if ((u > 0 && v > 0 && r > 0) || (u < 0 && v < 0 && r < 0)) crossings++;
          }
        }
  }
  return crossings;
}

}  // namespace thaw::test
