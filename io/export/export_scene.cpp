// SPDX-License-Identifier: Apache-2.0
#include "io/export/export_scene.hpp"

namespace thaw {

std::vector<ComponentMesh> placedParts(const ExportObject& object) {
  std::vector<ComponentMesh> parts = object.parts;
  if (!object.pose || !object.moves) return parts;
  const Pose& pose = *object.pose;
  for (ComponentMesh& part : parts) {
    part.velocities.clear();
    for (Vec3d& x : part.mesh.vertices) {
      x = fromRest(pose, x);
      part.velocities.push_back(single(velocityAt(pose, x)));
    }
    for (Vec3f& n : part.normals) n = single(directionFromRest(pose, {n.x, n.y, n.z}));
  }
  return parts;
}

std::vector<ComponentMesh> placedParts(const ExportScene& scene) {
  std::vector<ComponentMesh> all;
  for (const ExportObject& object : scene.objects)
    for (ComponentMesh& part : placedParts(object)) all.push_back(std::move(part));
  return all;
}

}  // namespace thaw
