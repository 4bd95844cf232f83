// SPDX-License-Identifier: Apache-2.0
#include "io/render/scene_job.hpp"

#include <filesystem>
#include <sstream>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/terms/find_modules.hpp"
#include "io/image/linear_light.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"

namespace thaw {

Lighting lightingOf(const Output& output) {
  Lighting lighting;
  if (output.background) lighting.background = rgbOf(*output.background);
  if (output.backgroundTop) lighting.backgroundTop = rgbOf(*output.backgroundTop);
  lighting.sun = output.sun;
  for (const PictureLight& l : output.lights)
    lighting.lights.push_back(
        {l.direction, static_cast<float>(l.strength) * toLinear(rgbOf(l.colour)), l.size});
  lighting.ambient = static_cast<float>(output.ambient);
  return lighting;
}

FrameJob jobOfScene(const Scene& scene) {
  FrameJob job;
  job.title = scene.title;
  job.field = !scene.output.colour.empty()                                              ? scene.output.colour
              : modulesOf(scene).heat                                                   ? "temperature"
              : !scene.sheets.empty() && scene.bodies.empty() && scene.emitters.empty() ? "surface"
                                                                                        : "speed";
  job.min = scene.output.colourMin;
  job.max = scene.output.colourMax;
  if (!scene.output.camera.fitted) job.camera = scene.output.camera;
  job.width = scene.output.width;
  job.height = scene.output.height;
  job.spacing = static_cast<float>(scene.spacing);
  job.interval = scene.output.every;
  job.periodic = periodicSidesOf(scene.domain);
  job.lighting = lightingOf(scene.output);
  job.spray = scene.output.spray;
  const MeshLoader load = meshLoader();
  for (const Obstacle& obstacle : scene.obstacles) {
    Wall wall;
    wall.shape = makeSignedDistance(obstacle.shape, load);
    wall.properties = obstacle;
    wall.bounds = wall.shape->bounds();
    job.walls.list.push_back(std::move(wall));
  }
  addDomainWalls(scene.domain, job.walls);
  addWallImages(scene.domain, 0, job.walls);
  return job;
}

Scene sceneOfText(const std::string& text, const std::string& name) {
  const std::string fileMark = "# ---- ", overrideMark = "# --set ";
  SceneFiles files;
  std::vector<std::string> overrides;
  std::string path;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(fileMark)) {
      path = line.substr(fileMark.size());
      files.texts[path] = "";
      if (std::filesystem::path(path).stem() == name) files.main = path;
    } else if (line.starts_with(overrideMark)) {
      overrides.push_back(line.substr(overrideMark.size()));
    } else if (!path.empty()) {
      files.texts[path] += line + "\n";
    }
  }
  if (files.main.empty()) throw SceneErrors({"the scene text has no file named '" + name + "'"});
  return readScene(files, overrides);
}

}  // namespace thaw
