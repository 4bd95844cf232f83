// Smooth normals of a triangle mesh that keep its edges.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

class MeshNormals {
 public:
  explicit MeshNormals(const TriangleMesh& mesh);
  /// Unit normal at a point of a triangle: between those of its corners, each as the file has it, or where
  /// that says nothing the mean of the triangles around it by their angle there, as far as they turn less
  /// than 45 degrees from this one. Slivers whose normal differs from that across their longest edge say
  /// nothing.
  Vec3d at(const Vec3d& x, std::uint32_t triangle) const;
  /// Colour between those of the corners; the mesh has to have some.
  std::uint32_t colourAt(const Vec3d& x, std::uint32_t triangle) const;

 private:
  std::array<double, 3> sharesOf(const Vec3d& x, std::uint32_t triangle) const;
  Vec3d cornerNormal(std::uint32_t triangle, std::uint32_t vertex) const;
  void mendSlivers();
  const TriangleMesh& mesh_;
  std::vector<Vec3d> face_;                    // unit normals
  std::vector<std::uint8_t> doubtful_;         // of triangles: a sliver whose own normal says nothing
  std::vector<std::uint32_t> first_, around_;  // triangles of each vertex
};

}  // namespace thaw
