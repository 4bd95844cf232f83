// SPDX-License-Identifier: Apache-2.0
// Smooth normals of a triangle mesh that keep sharp edges.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

class MeshNormals {
 public:
  explicit MeshNormals(const TriangleMesh& mesh);
  /// Returns the unit normal at a point of a triangle, interpolated between its corners. Corner normals come
  /// from the file. Without them, they are means over the surrounding triangles that deviate by less than 45
  /// degrees, weighted by angle. Slivers are ignored if their normal differs from the one across their
  /// longest edge.
  Vec3d at(const Vec3d& x, std::uint32_t triangle) const;
  /// Returns the interpolated colour of the corners. Requires: a mesh with vertex colours.
  std::uint32_t colourAt(const Vec3d& x, std::uint32_t triangle) const;

 private:
  std::array<double, 3> sharesOf(const Vec3d& x, std::uint32_t triangle) const;
  Vec3d cornerNormal(std::uint32_t triangle, std::uint32_t vertex) const;
  void repairSlivers();
  const TriangleMesh& mesh_;
  std::vector<Vec3d> face_;                    // unit normals
  std::vector<std::uint8_t> doubtful_;         // flags triangles: slivers with an unreliable normal
  std::vector<std::uint32_t> first_, around_;  // triangles of each vertex
};

}  // namespace thaw
