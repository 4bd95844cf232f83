// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/mesh/triangulate.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/mesh/manifold.hpp"

namespace thaw {
namespace {

constexpr std::size_t mostSides = 14;           // maximum number of edges of a filled hole
constexpr double longest = 2.0, widest = 1.25;  // spacings: largest edge of a triangle, largest radius of its
                                                // sphere

bool sameSurface(const OrientedPoints& p, std::uint32_t i, std::uint32_t j) {
  constexpr std::uint64_t first = 0x5555555555555555ull;
  if (!p.groups.empty() && p.groups[i] != p.groups[j]) return false;
  if (!p.cutSides.empty()) {
    const std::uint64_t a = p.cutSides[i], b = p.cutSides[j];
    if ((a & first & (b >> 1)) | ((a >> 1) & first & b)) return false;
  }
  return true;
}
bool alike(const OrientedPoints& p, std::uint32_t i, std::uint32_t j) {
  return sameSurface(p, i, j) && dot(p.normals[i], p.normals[j]) > 0;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const OrientedPoints& p) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (p.positions.size() < 3) return triangles;
  const std::vector<Vec3d> places(p.positions.begin(), p.positions.end());
  const PointTree tree(places);
  for (std::uint32_t i = 0; i < places.size(); i++) {
    const double reach = longest * p.spacings[i];
    std::vector<std::uint32_t> near;
    for (const std::uint32_t j : tree.within(places[i], reach))
      if (j != i && alike(p, i, j)) near.push_back(j);
    for (std::size_t a = 0; a < near.size(); a++) {
      if (near[a] < i) continue;
      for (std::size_t b = a + 1; b < near.size(); b++) {
        const std::uint32_t j = near[a], k = near[b];
        const Vec3d u = places[j] - places[i], v = places[k] - places[i], across = cross(u, v);
        const double area2 = dot(across, across);
        if (!alike(p, j, k) || !(area2 > 1e-8 * dot(u, u) * dot(v, v))) continue;
        const Vec3d toCentre = (dot(u, u) * cross(v, across) + dot(v, v) * cross(across, u)) / (2 * area2);
        const double r2 = dot(toCentre, toCentre);
        if (r2 > widest * widest * p.spacings[i] * p.spacings[i]) continue;
        const Vec3d centre = places[i] + toCentre;
        bool empty = true;
        for (const std::uint32_t q : near) {
          if (q == j || q == k) continue;
          const Vec3d d = places[q] - centre;
          if (dot(d, d) < r2 * (1 - 1e-7)) {
            empty = false;
            break;
          }
        }
        if (!empty) continue;
        const bool turned = dot(across, p.normals[i] + p.normals[j] + p.normals[k]) < 0;
        triangles.push_back({i, turned ? k : j, turned ? j : k});
      }
    }
  }
  // independent triangles overlap, or leave gaps, at sharp bends
  triangles = keepManifold(p, std::move(triangles));
  fillHoles(p, triangles, mostSides, 2 * widest + 1e-9);  // no edge is longer than the circle's diameter
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<std::array<std::uint32_t, 2>> joinLines(const OrientedPoints& p,
                                                    std::span<const std::uint8_t> wanted) {
  std::vector<std::array<std::uint32_t, 2>> lines;
  const std::vector<Vec3d> places(p.positions.begin(), p.positions.end());
  if (places.size() < 2) return lines;
  const PointTree tree(places);
  for (std::uint32_t i = 0; i < places.size(); i++) {
    if (!wanted[i]) continue;
    const std::vector<std::uint32_t> near = tree.within(places[i], longest * p.spacings[i]);
    for (const std::uint32_t j : near) {
      if (j <= i || !wanted[j] || !sameSurface(p, i, j)) continue;
      const Vec3d centre = 0.5 * (places[i] + places[j]), half = 0.5 * (places[j] - places[i]);
      const bool empty = std::none_of(near.begin(), near.end(), [&](std::uint32_t q) {
        const Vec3d d = places[q] - centre;
        return q != i && q != j && sameSurface(p, i, q) && dot(d, d) < dot(half, half) * (1 - 1e-7);
      });
      if (empty) lines.push_back({i, j});
    }
  }
  return lines;
}

std::vector<std::array<std::uint32_t, 2>> edgesOf(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; k++) {
      const std::uint32_t a = t[static_cast<std::size_t>(k)], b = t[static_cast<std::size_t>((k + 1) % 3)];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace thaw
