#include "io/render/scene_job.hpp"

#include "core/geometry/signed_distance.hpp"
#include "core/scene/modules.hpp"

namespace thaw {

FrameJob jobOfScene(const Scene& scene) {
  FrameJob job;
  job.title = scene.title;
  job.field = !scene.output.colour.empty() ? scene.output.colour : modulesOf(scene).heat ? "temperature" : "speed";
  job.min = scene.output.colourMin;
  job.max = scene.output.colourMax;
  if (!scene.output.camera.fitted) job.camera = scene.output.camera;
  job.width = scene.output.width;
  job.height = scene.output.height;
  job.spacing = static_cast<float>(scene.spacing);
  for (const Obstacle& obstacle : scene.obstacles) {
    Wall wall;
    wall.shape = makeSignedDistance(obstacle.shape);
    wall.properties = obstacle;
    wall.bounds = wall.shape->bounds();
    job.walls.list.push_back(std::move(wall));
  }
  addDomainWalls(scene.domain, job.walls);
  return job;
}

}  // namespace thaw
