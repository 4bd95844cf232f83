// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/blue_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/geometry/trees/point_cells.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

// in spacings
constexpr double pieceSize = 0.55, closest = 0.75, largestGap = 0.85;
// smallest dot product of the normals of triangles that interact
constexpr double sameSide = -0.3;
constexpr int lloydSteps = 2;
constexpr std::uint32_t noSample = 0xffffffffu;

struct Candidates {
  std::vector<Vec3d> position;
  std::vector<std::uint32_t> triangle;
  std::vector<float> area;  // m^2, area of the piece
};

/// Divides a triangle across its longest edge until the pieces are small. Adds one candidate in each piece.
void addPieces(const std::array<Vec3d, 3>& t, std::uint32_t triangle, double size2, std::uint64_t seed,
               const MeshPart* part, Candidates& c) {
  int longest = 0;
  double most = -1;
  for (int k = 0; k < 3; k++) {
    const Vec3d e = t[(k + 1) % 3] - t[k];
    if (dot(e, e) > most) most = dot(e, e), longest = k;
  }
  const Vec3d &a = t[longest], &b = t[(longest + 1) % 3], &o = t[(longest + 2) % 3];
  if (most > size2) {
    const Vec3d m = 0.5 * (a + b);
    if (part && !part->near(m, std::sqrt(most)))
      // No corner is farther from the middle of the longest edge than its ends.
      return;
    addPieces({a, m, o}, triangle, size2, seed, part, c);
    addPieces({m, b, o}, triangle, size2, seed, part, c);
    return;
  }
  const double area = 0.5 * length(cross(b - a, o - a));
  if (!(area > 0)) return;
  const std::uint64_t n = c.position.size();
  double u = randomUniform(seed, Purpose::SurfelSample, n, 1),
         v = randomUniform(seed, Purpose::SurfelSample, n, 2);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3d place = a + u * (b - a) + v * (o - a);
  if (part && !part->isThere(place, triangle)) return;
  c.position.push_back(place);
  c.triangle.push_back(triangle);
  c.area.push_back(static_cast<float>(area));
}

/// Sorts candidates by cell for local access.
void sortByCells(Candidates& c, const PointCells& cells) {
  Candidates s;
  s.position.reserve(c.position.size());
  s.triangle.reserve(c.position.size());
  s.area.reserve(c.position.size());
  for (const std::uint32_t k : cells.order()) {
    s.position.push_back(c.position[k]);
    s.triangle.push_back(c.triangle[k]);
    s.area.push_back(c.area[k]);
  }
  c = std::move(s);
}

struct Sampler {
  const TriangleMesh& mesh;
  double spacing;
  std::uint64_t seed;
  std::vector<Vec3f> normal;  // normals of triangles
  Candidates all;
  std::vector<std::uint32_t> nearest;  // index of the nearest sample of each candidate
  std::vector<MeshSample> places;

  bool onOneSide(std::uint32_t t, std::uint32_t u) const {
    return static_cast<double>(dot(normal[t], normal[u])) > sameSide;
  }

  /// Accepts candidates in a hashed order. Accepted candidates are at least `distance` apart.
  void throwDarts(const PointCells& cells, double distance) {
    const std::size_t n = all.position.size();
    std::vector<char> gone(n, 0);
    int bits = 2;
    while ((std::uint64_t{1} << bits) < n) bits++;
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1, start = mixBits(seed);
    for (std::uint64_t k = 0; k <= mask; k++) {
      // This is a bijection, since odd factors and shifted xors are invertible.
      std::uint64_t x = (k + start) & mask;
      x = x * 0x9e3779b97f4a7c15ull & mask, x ^= x >> (bits / 2), x = x * 0xbf58476d1ce4e5b9ull & mask,
      x ^= x >> (bits / 2);
      if (x >= n || gone[x]) continue;
      places.push_back({all.position[x], all.triangle[x]});
      cells.around(all.position[x], [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t j = first; j < last; j++) {
          const Vec3d d = all.position[j] - all.position[x];
          if (dot(d, d) < distance * distance && onOneSide(all.triangle[j], all.triangle[x])) gone[j] = 1;
        }
      });
    }
  }

  /// Finds the nearest sample within `reach` (m) of each candidate; noSample if there is none.
  void findNearest(double reach) {
    std::vector<Vec3d> at;
    at.reserve(places.size());
    for (const MeshSample& s : places) at.push_back(s.position);
    const PointCells cells(at, reach);
    nearest.assign(all.position.size(), noSample);
    std::vector<std::uint32_t> near;
    std::uint64_t here = ~std::uint64_t{0};
    for (std::size_t k = 0; k < all.position.size(); k++) {
      const std::uint64_t key = cells.keyOf(all.position[k]);
      if (key != here) {
        here = key;
        near.clear();
        cells.around(all.position[k], [&](std::uint32_t first, std::uint32_t last) {
          near.insert(near.end(), cells.order().begin() + first, cells.order().begin() + last);
        });
      }
      double best = reach * reach;
      for (const std::uint32_t p : near) {
        const Vec3d d = at[p] - all.position[k];
        if (dot(d, d) < best && onOneSide(places[p].triangle, all.triangle[k]))
          best = dot(d, d), nearest[k] = p;
      }
    }
  }

  /// Moves each sample to the centroid of its candidates, on the triangle of the candidate nearest to the
  /// centroid.
  void moveToMiddles() {
    std::vector<Vec3d> middle(places.size());
    std::vector<double> weight(places.size(), 0), best(places.size(), 1e300);
    for (std::size_t k = 0; k < nearest.size(); k++)
      if (nearest[k] != noSample) {
        middle[nearest[k]] += static_cast<double>(all.area[k]) * all.position[k];
        weight[nearest[k]] += static_cast<double>(all.area[k]);
      }
    std::vector<std::uint32_t> triangle(places.size(), noSample);
    for (std::size_t k = 0; k < nearest.size(); k++) {
      const std::uint32_t p = nearest[k];
      if (p == noSample) continue;
      const Vec3d d = all.position[k] - middle[p] / weight[p];
      if (dot(d, d) < best[p]) best[p] = dot(d, d), triangle[p] = all.triangle[k];
    }
    for (std::size_t p = 0; p < places.size(); p++) {
      if (triangle[p] == noSample) continue;
      const auto& t = mesh.triangles[triangle[p]];
      places[p] = {closestPointOfTriangle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]],
                                          middle[p] / weight[p]),
                   triangle[p]};
    }
  }

  /// Accepts candidates farther than `distance` from all samples.
  void fillHoles(double distance) {
    findNearest(spacing);
    Candidates lonely;
    for (std::size_t k = 0; k < nearest.size(); k++) {
      const Vec3d d = nearest[k] == noSample ? Vec3d{} : places[nearest[k]].position - all.position[k];
      if (nearest[k] != noSample && dot(d, d) <= distance * distance) continue;
      lonely.position.push_back(all.position[k]);
      lonely.triangle.push_back(all.triangle[k]);
      lonely.area.push_back(all.area[k]);
    }
    if (lonely.position.empty()) return;
    all = std::move(lonely);
    const PointCells cells(all.position, distance);
    sortByCells(all, cells);
    throwDarts(cells, distance);
  }
};

}  // namespace

std::vector<MeshSample> blueNoise(const TriangleMesh& mesh, double spacing, std::uint64_t seed,
                                  const MeshPart* part) {
  Sampler s{mesh, spacing, seed, {}, {}, {}, {}};
  s.normal.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++) {
    const auto& c = mesh.triangles[t];
    const Vec3d n = normalized(
        cross(mesh.vertices[c[1]] - mesh.vertices[c[0]], mesh.vertices[c[2]] - mesh.vertices[c[0]]));
    s.normal.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    addPieces({mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]}, t,
              pieceSize * pieceSize * spacing * spacing, seed, part, s.all);
  }
  if (s.all.position.empty()) return {};
  const PointCells cells(s.all.position, closest * spacing);
  sortByCells(s.all, cells);
  s.throwDarts(cells, closest * spacing);
  for (int k = 0; k < lloydSteps; k++) {
    s.findNearest(1.2 * spacing);
    s.moveToMiddles();
  }
  s.fillHoles(largestGap * spacing);
  return std::move(s.places);
}

}  // namespace thaw
