// Signed distance from a triangle mesh.
#pragma once
#include <memory>
#include <string>

#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/signed_distance.hpp"
#include "core/geometry/triangle_bvh.hpp"

namespace thaw {

/// Cubes that the surface does not pass, with the signed distance at their middle: answers most questions far from the surface
/// without looking at a triangle, and bounds the rest.
class DistanceOctree {
 public:
  struct Leaf { Vec3d middle; double distance = 0; bool clear = false; };  ///< clear: no surface within
  DistanceOctree() = default;
  /// Distances are to `near`, signs from the winding numbers of `all`.
  DistanceOctree(const TriangleBvh& near, const TriangleBvh& all);
  bool covers(const Vec3d& x) const;
  Leaf leafAt(const Vec3d& x) const;  ///< of a point that is covered

 private:
  struct Cube { std::int32_t children = -1; bool clear = false; double distance = 0; };
  std::vector<Cube> cubes_;  ///< the 8 children of a cube stand together
  Vec3d middle_{};
  double half_ = 0;
};

/// The mesh is repaired first (mesh_repair.hpp). Distances are to the nearest triangle, holes' patches included; the sign is that of
/// the winding number less 1/2. Where shells overlap, triangles of one that are buried in another do not count; those that are so
/// only in part do, and distances inside may be too small near them.
class MeshDistance final : public SignedDistance {
 public:
  MeshDistance(const TriangleMesh& mesh, std::string name);
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const override;
  bool inside(const Vec3d& x) const override;
  Bounds bounds() const override { return surface_->bounds(); }
  double extent(const Vec3d& direction) const override;
  bool hasGaps() const override { return !report_.closed; }
  void addNotes(std::vector<std::string>& notes) const override;
  const MeshReport& report() const { return report_; }
  const TriangleBvh& surface() const { return *surface_; }  ///< all triangles
  const TriangleBvh& visible() const { return visible_ ? *visible_ : *surface_; }  ///< without buried ones

 private:
  double signedFrom(const ClosestPoint& closest, const Vec3d& x, bool inside, Vec3d* gradient) const;
  std::string name_;
  MeshReport report_;
  std::vector<Vec3d> corners_;  ///< of the mesh, for extents
  std::unique_ptr<const TriangleBvh> surface_, visible_;
  DistanceOctree octree_;
};

}  // namespace thaw
