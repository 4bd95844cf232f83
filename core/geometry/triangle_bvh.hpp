// Bounding-volume hierarchy of triangles: closest points, and winding numbers by dipole expansion (Barill,
// Dickson, Schmidt, Levin, Jacobson 2018, "Fast winding numbers for soups and clouds").
#pragma once
#include <cstdint>
#include <limits>

#include "core/geometry/signed_distance.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "core/particles/aligned_memory.hpp"

namespace thaw {

struct ClosestPoint {
  Vec3d point{};   ///< m, on the surface
  Vec3d normal{};  ///< unit normal of the triangle it is on, 0 for a triangle without area
  double distance2 = std::numeric_limits<double>::infinity();  ///< m^2; infinite: nothing within reach
  std::uint32_t triangle = 0;                                  ///< number of that triangle in the mesh
};

class TriangleBvh {
 public:
  /// The indices of the mesh have to be valid, the vertices finite.
  explicit TriangleBvh(const TriangleMesh& mesh);
  /// Closest point nearer than `reach` (m). Of points equally near the first in a fixed order.
  ClosestPoint closest(const Vec3d& x, double reach = std::numeric_limits<double>::infinity()) const;
  /// How often the surface winds around x: 1 inside and 0 outside a closed, outward surface, within 0.1 by
  /// the expansion; `accuracy` is the distance in radii of a group of triangles from which it counts as a
  /// dipole.
  double winding(const Vec3d& x, double accuracy = 2.0) const;
  bool meets(const Bounds& box) const;  ///< Does the box of any triangle touch this one?
  Bounds bounds() const { return nodes_.empty() ? Bounds{} : Bounds{nodes_[0].low, nodes_[0].high}; }
  std::size_t memory() const;  ///< bytes

 private:
  struct Corners {
    Vec3d a, b, c;
  };
  struct Node {
    Vec3d low, high;
    std::uint32_t first = 0;  ///< leaf: first triangle; else the second child (the first one follows its
                              ///< parent)
    std::uint32_t count = 0;  ///< leaf: triangles; else 0
  };
  struct Dipole {
    Vec3d centre, moment;  ///< m, m^2: sum of area times normal
    double radius2 = 0;    ///< m^2, no vertex is farther from the centre
  };
  struct Builder;
  AlignedVector<Node> nodes_;  ///< depth first
  AlignedVector<Dipole> dipoles_;
  AlignedVector<Corners> triangles_;
  AlignedVector<std::uint32_t> numbers_;  ///< of these in the mesh
};

/// Solid angle over 4 pi of a triangle seen from x, positive from behind (Van Oosterom and Strackee 1983).
double windingOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

/// Closest point of a triangle, which may be without area.
Vec3d closestPointOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

}  // namespace thaw
