// SPDX-License-Identifier: Apache-2.0
// Signed distance from a triangle mesh.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/meshes/mesh_repair.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"

namespace thaw {

/// Cubes that the surface does not cross, with the signed distance (m) at their centre. Far from the surface,
/// they give most results without a test of triangles, and bounds for the others. A cube is evaluated at the
/// first query in it, so a rank evaluates only its part of a body. The result does not depend on the order of
/// queries. Queries are safe from several threads.
class DistanceOctree {
 public:
  struct Leaf {
    Vec3d middle;
    double distance = 0;
    bool clear = false;
  };  ///< clear: the surface does not cross it
  /// Distances are to `near`, and signs follow from winding numbers of `all`. Requires: both objects outlive
  /// this one.
  DistanceOctree(const TriangleBvh& near, const TriangleBvh& all);
  ~DistanceOctree();
  bool covers(const Vec3d& x) const;
  Leaf leafAt(const Vec3d& x) const;  ///< requires covers(x)

 private:
  struct Cube;
  /// Evaluates a cube with this centre and half edge (m). `bound` (m) slightly exceeds the distance of the
  /// surface from the centre.
  void look(Cube& cube, const Vec3d& middle, double half, double bound, int depth) const;
  const TriangleBvh &near_, &all_;
  std::unique_ptr<Cube> root_;
  mutable std::mutex looking_;
  Vec3d middle_{};
  double half_ = 0;
};

/// The mesh is repaired first (mesh_repair.hpp). The distance is to the nearest triangle, including
/// triangles that close holes. The sign follows from the winding number minus 1/2. Where shells overlap,
/// triangles buried in another shell do not count. Partly buried triangles count, so distances inside may be
/// too small near them.
class MeshDistance final : public SignedDistance {
 public:
  MeshDistance(const TriangleMesh& mesh, std::string name);
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const override;
  bool inside(const Vec3d& x) const override;
  void insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                   KnownSides& known) const override;
  Bounds bounds() const override { return surface_->bounds(); }
  double extent(const Vec3d& direction) const override;
  bool hasGaps() const override { return !report_.closed; }
  double area() const override { return area_; }
  void addNotes(std::vector<std::string>& notes) const override;
  const MeshReport& report() const { return report_; }
  const TriangleBvh& surface() const { return *surface_; }                         ///< all triangles
  const TriangleBvh& visible() const { return visible_ ? *visible_ : *surface_; }  ///< without buried ones

 private:
  double signedFrom(const ClosestPoint& closest, const Vec3d& x, bool inside, Vec3d* gradient) const;
  std::string name_;
  MeshReport report_;
  double area_ = 0;
  std::vector<Vec3d> corners_;  ///< corners of the mesh, for extents
  std::unique_ptr<const TriangleBvh> surface_, visible_;
  std::unique_ptr<const DistanceOctree> octree_;  ///< nullptr: the mesh is open
};

}  // namespace thaw
