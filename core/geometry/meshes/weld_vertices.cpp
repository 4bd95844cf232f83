// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/weld_vertices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

using Index = std::uint32_t;
constexpr Index none = 0xffffffffu;

/// Returns for each vertex the first equal one, by a hash table with open addressing.
std::vector<Index> firstEqual(const std::vector<Vec3d>& v) {
  std::vector<Index> first(v.size()), table(std::bit_ceil(2 * v.size() + 1), none);
  const auto bits = [](double c) { return std::bit_cast<std::uint64_t>(c + 0.0); };  // -0 is 0
  for (Index n = 0; n < v.size(); n++) {
    std::size_t at = mixBits(mixBits(mixBits(bits(v[n].x)) + bits(v[n].y)) + bits(v[n].z)) &
                     (table.size() - 1);
    while (table[at] != none && !(v[table[at]] == v[n])) at = (at + 1) & (table.size() - 1);
    if (table[at] == none) table[at] = n;
    first[n] = table[at];
  }
  return first;
}

/// Returns for each vertex the first vertex nearby, by a hash of cells with an edge of twice the tolerance.
/// The hash table is never iterated, so the result is deterministic.
std::vector<Index> firstNear(const std::vector<Vec3d>& v, double tolerance) {
  std::unordered_map<std::uint64_t, std::vector<Index>> cells;
  std::vector<Index> first(v.size());
  const double scale = 1 / (2 * tolerance);
  const auto key = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return mixBits(mixBits(mixBits(static_cast<std::uint64_t>(i)) + static_cast<std::uint64_t>(j)) +
                   static_cast<std::uint64_t>(k));
  };
  for (Index n = 0; n < v.size(); n++) {
    const Vec3d x = v[n];
    const auto cell = [&](double c) { return static_cast<std::int64_t>(std::floor(c * scale)); };
    Index found = none;
    for (std::int64_t i = cell(x.x - tolerance); i <= cell(x.x + tolerance); i++)
      for (std::int64_t j = cell(x.y - tolerance); j <= cell(x.y + tolerance); j++)
        for (std::int64_t k = cell(x.z - tolerance); k <= cell(x.z + tolerance); k++) {
          const auto at = cells.find(key(i, j, k));
          if (at == cells.end()) continue;
          for (const Index m : at->second) {
            const Vec3d d = v[m] - x;
            if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= tolerance)
              found = std::min(found, m);
          }
        }
    first[n] = found == none ? n : found;
    if (found == none) cells[key(cell(x.x), cell(x.y), cell(x.z))].push_back(n);
  }
  return first;
}

}  // namespace

TriangleMesh weldVertices(const TriangleMesh& mesh, double tolerance) {
  const std::vector<Index> first = tolerance > 0 ? firstNear(mesh.vertices, tolerance)
                                                 : firstEqual(mesh.vertices);
  std::vector<Index> number(mesh.vertices.size(), none);
  TriangleMesh out;
  std::vector<std::array<Index, 3>> sorted;
  for (std::size_t n = 0; n < mesh.triangles.size(); n++) {
    const auto& t = mesh.triangles[n];
    const std::array<Index, 3> c{first[t[0]], first[t[1]], first[t[2]]};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    out.triangles.push_back(c);
    if (!mesh.normals.empty()) out.normals.push_back(mesh.normals[n]);
    sorted.push_back(c);
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  // Sorts by the smallest corner into buckets in one pass, since few triangles share a corner.
  std::vector<Index> order(sorted.size()), end(mesh.vertices.size() + 1, 0);
  for (const auto& t : sorted) end[t[0] + 1]++;
  for (std::size_t v = 1; v < end.size(); v++) end[v] += end[v - 1];
  for (Index t = 0; t < sorted.size(); t++) order[end[sorted[t][0]]++] = t;
  for (std::size_t v = 0; v + 1 < end.size(); v++)
    std::sort(order.begin() + (v > 0 ? end[v - 1] : 0), order.begin() + end[v],
              [&](Index a, Index b) { return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b; });
  std::vector<char> twice(sorted.size(), 0);
  for (std::size_t k = 1; k < order.size(); k++) twice[order[k]] = sorted[order[k]] == sorted[order[k - 1]];
  std::size_t kept = 0;
  for (std::size_t t = 0; t < out.triangles.size(); t++) {
    if (twice[t]) continue;
    std::array<Index, 3> c = out.triangles[t];
    for (Index& v : c) {
      if (number[v] == none) {
        number[v] = static_cast<Index>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
        if (!mesh.colours.empty()) out.colours.push_back(mesh.colours[v]);
      }
      v = number[v];
    }
    if (!out.normals.empty()) out.normals[kept] = out.normals[t];
    out.triangles[kept++] = c;
  }
  out.triangles.resize(kept);
  if (!out.normals.empty()) out.normals.resize(kept);
  return out;
}

}  // namespace thaw
