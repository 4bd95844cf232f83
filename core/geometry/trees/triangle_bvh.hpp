// SPDX-License-Identifier: Apache-2.0
// Bounding-volume hierarchy of triangles: closest points, and winding numbers by dipole expansion (B18).
#pragma once
#include <cstdint>
#include <limits>

#include "core/fields/aligned_memory.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

struct ClosestPoint {
  Vec3d point{};   ///< m, on the surface
  Vec3d normal{};  ///< unit normal of its triangle; 0 for a degenerate triangle
  double distance2 = std::numeric_limits<double>::infinity();  ///< m^2; infinite: no point within reach
  std::uint32_t triangle = 0;                                  ///< its triangle in the mesh
};

class TriangleBvh {
 public:
  /// Requires: valid indices and finite vertices.
  explicit TriangleBvh(const TriangleMesh& mesh);
  /// Returns the closest point within `reach` (m). Of equally close points, it is the first in a fixed order.
  ClosestPoint closest(const Vec3d& x, double reach = std::numeric_limits<double>::infinity()) const;
  /// Returns the winding number at x: 1 inside and 0 outside a closed, outward surface, accurate to 0.1. A
  /// group of triangles counts as a dipole beyond `accuracy` times its radius.
  double winding(const Vec3d& x, double accuracy = 2.0) const;
  bool meets(const Bounds& box) const;  ///< true if the box of any triangle touches this one
  Bounds bounds() const { return nodes_.empty() ? Bounds{} : Bounds{nodes_[0].low, nodes_[0].high}; }
  std::size_t memory() const;  ///< bytes

 private:
  struct Corners {
    Vec3d a, b, c;
  };
  struct Node {
    Vec3d low, high;
    std::uint32_t first = 0;  ///< leaf: first triangle; else the second child (the first child follows its
                              ///< parent)
    std::uint32_t count = 0;  ///< leaf: triangles; else 0
  };
  struct Dipole {
    Vec3d centre, moment;  ///< m, m^2: sum of area times normal
    double radius2 = 0;    ///< m^2, upper bound over all vertices
  };
  struct Builder;
  AlignedVector<Node> nodes_;  ///< depth first
  AlignedVector<Dipole> dipoles_;
  AlignedVector<Corners> triangles_;
  AlignedVector<std::uint32_t> numbers_;  ///< numbers of these triangles in the mesh
};

/// Returns the solid angle over 4 pi of a triangle seen from x, positive from behind (VOS83).
double windingOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

/// Returns the closest point of a triangle, which may be degenerate.
Vec3d closestPointOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

}  // namespace thaw
