// SPDX-License-Identifier: Apache-2.0
// Checks of closed meshes.
#pragma once
#include <gtest/gtest.h>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/meshes/mesh_edges.hpp"
#include "core/math/disjoint_sets.hpp"

namespace thaw {

/// Checks that every edge has two triangles that run along it in opposite directions.
inline void expectClosed(const TriangleMesh& mesh) {
  const AlignedVector<EdgeSide> sides = edgeSides(mesh);
  std::size_t wrong = 0;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    wrong += last - first != 2 || sides[first].sign + sides[first + 1].sign != 0;
  });
  EXPECT_EQ(wrong, 0u);
  for (const auto& t : mesh.triangles) EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
}

/// Volumes (m^3) of the shells of a mesh; negative for cavities.
inline std::vector<double> shellVolumes(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const auto& t : mesh.triangles) sets.join(t[0], t[1]), sets.join(t[1], t[2]);
  std::vector<double> of(mesh.vertices.size()), shells;
  for (const auto& t : mesh.triangles)
    of[sets.find(t[0])] += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
  for (std::uint32_t v = 0; v < of.size(); v++)
    if (sets.find(v) == v) shells.push_back(of[v]);
  return shells;
}

}  // namespace thaw
