// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/commands/export/gather_scene.hpp"
#include "io/surface_mesh/obstacle_mesh.hpp"

namespace thaw {

namespace {

constexpr float glassOpacity = 0.25f;

}  // namespace

std::vector<ExportObject> obstaclesOf(const Scene& scene, std::vector<std::string>& warnings) {
  std::vector<ExportObject> all;
  for (std::size_t k = 0; k < scene.obstacles.size(); k++) {
    const Obstacle& obstacle = scene.obstacles[k];
    ExportObject object{obstacle.name.empty() ? fmt::format("obstacle_{}", k) : obstacle.name,
                        ExportKind::Obstacle,
                        {},
                        Pose{},
                        !obstacle.motion.empty()};
    // A plane of glass is a floor in pictures.
    if (obstacle.look == ObstacleLook::Glass && obstacle.shape.kind != ShapeKind::HalfSpace)
      object.opacity = glassOpacity;
    try {
      object.parts.push_back(obstacleMesh(obstacle, scene.domain, ObstacleTriangles::Even));
    } catch (const std::exception& error) {  // the mesh file may be missing on this machine
      warnings.push_back(fmt::format("obstacle {} is left out: {}", object.name, error.what()));
    }
    all.push_back(std::move(object));
  }
  return all;
}

void gatherObstacles(const RunScene& stored, ExportScene& scene, GatherNotes& notes) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < stored.obstacles.size(); k++) {
    const Obstacle& obstacle = stored.scene.obstacles[k];
    if (scene.time >= obstacle.until || stored.obstacles[k].parts.empty()) continue;
    scene.objects.push_back(stored.obstacles[k]);
    scene.objects.back().pose = poseAt(obstacle.motion, scene.time);
    count++;
  }
  if (count > 0)
    notes.summary += fmt::format("{}{} obstacle{}", notes.summary.empty() ? "" : ", ", count,
                                 count == 1 ? "" : "s");
}

}  // namespace thaw
