// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/placed_mesh.hpp"

#include <algorithm>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/builtin_meshes.hpp"

namespace thaw {
namespace {

/// Shape with extents only. A placement needs no more.
class MeshReach final : public SignedDistance {
 public:
  explicit MeshReach(const TriangleMesh& mesh) : mesh_(mesh), bounds_(boundsFromExtents(*this)) {}
  double distance(const Vec3d&, Vec3d*) const override { return 0; }
  Bounds bounds() const override { return bounds_; }
  double extent(const Vec3d& direction) const override {
    double e = -never;
    for (const Vec3d& v : mesh_.vertices) e = std::max(e, dot(direction, v));
    return e;
  }

 private:
  const TriangleMesh& mesh_;
  Bounds bounds_;
};

PlacedMesh placed(const Shape& s, const MeshLoader& load,
                  TriangleMesh repair(const TriangleMesh&, MeshReport&)) {
  if (!isBuiltin(s.mesh) && !load)
    throw ShapeError("mesh '" + s.mesh + "': no mesh reader is available", s.where);
  PlacedMesh m;
  m.mesh = repair(isBuiltin(s.mesh) ? builtinMesh(s.mesh) : load(s.mesh), m.report);
  m.placement = placeMesh(s, m.mesh);
  return m;
}

}  // namespace

PlacedMesh makePlacedMesh(const Shape& s, const MeshLoader& load) { return placed(s, load, repairMesh); }

PlacedMesh makePlacedSurface(const Shape& s, const MeshLoader& load) {
  return placed(s, load, repairSurface);
}

Placement placementOfMesh(const Shape& s, const TriangleMesh& mesh) {
  return placementOf(s, std::make_shared<MeshReach>(mesh));
}

Placement placeMesh(const Shape& s, TriangleMesh& mesh) {
  const Placement p = placementOfMesh(s, mesh);
  for (Vec3d& v : mesh.vertices) v = p.move + p.rotation * (p.scale * v);
  for (auto& corners : mesh.normals)
    for (Vec3d& n : corners) n = p.rotation * n;
  return p;
}

}  // namespace thaw
