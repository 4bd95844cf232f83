// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/mesh_fingerprints.hpp"

#include <map>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/builtin_meshes.hpp"
#include "core/terms/extensions.hpp"
#include "io/scene/text/checksum.hpp"

namespace thaw {
namespace {

/// Calls use(shape) for each shape of a scene, without their parts.
template<class Use> void eachShape(Scene& s, Use&& use) {
  const auto all = [&](auto& list) {
    for (auto& shape : list) use(shape);
  };
  for (Body& b : s.bodies) use(b.shape), all(b.clamp);
  for (Obstacle& o : s.obstacles) use(o.shape);
  eachTermElement(s, [&](const Extension&, const TermTable&, const TermElement& one) {
    if (one.shape) use(*one.shape);
  });
  for (SheetBody& b : s.sheets) {
    use(b.shape);
    all(b.clamp);
    for (SheetRegion& r : b.regions) use(r.shape);
  }
  for (OrientedBody& b : s.oriented) {
    use(b.shape);
    for (OrientedConstraint& a : b.constraints) use(a.region);
    for (OrientedField& f : b.fields) use(f.region);
    for (OrientedEvent& e : b.events) use(e.region);
  }
}

}  // namespace

MeshFingerprint fingerprintOf(const TriangleMesh& mesh) {
  Checksum sum;
  for (const Vec3d& x : mesh.vertices) sum.add(x);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) sum.add(std::uint64_t{v});
  return {static_cast<double>(mesh.vertices.size()), static_cast<double>(mesh.triangles.size()),
          sum.asDouble()};
}

void fingerprintMeshes(Scene& scene, const MeshLoader& load) {
  std::map<std::string, MeshFingerprint> known;
  SceneProblems problems;
  const auto mark = [&](auto&& again, Shape& s) -> void {
    for (Shape& part : s.parts) again(again, part);
    if (s.mesh.empty()) return;
    const auto [it, fresh] = known.try_emplace(s.mesh);
    if (fresh) {
      try {
        it->second = fingerprintOf(isBuiltin(s.mesh) ? builtinMesh(s.mesh) : load(s.mesh));
      } catch (const std::exception& e) { problems.add(s.where, e.what()); }
    }
    s.meshFingerprint = it->second;
  };
  eachShape(scene, [&](Shape& s) { mark(mark, s); });
  problems.raise();
}

}  // namespace thaw
