// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/gather_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/export/usd/layer.hpp"
#include "io/hdf5/h5_file.hpp"
#include "io/render/scene_job.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

/// Returns all points of a scene, for a fitted camera.
std::vector<Vec3f> placesOf(const ExportScene& scene) {
  std::vector<Vec3f> places;
  if (scene.surfels)
    for (const Vec3d& x : scene.surfels->positions) places.push_back(single(x));
  if (scene.points) places = scene.points->positions;
  for (const ExportObject& object : scene.objects)
    if (object.kind != ExportKind::Obstacle)
      for (const ComponentMesh& part : object.parts)
        for (const Vec3d& x : part.mesh.vertices) places.push_back(single(x));
  return places;
}

/// Returns camera, picture size and walls, as `thaw render` uses them.
RenderStyle styleOf(const FrameJob& picture, const ExportScene& scene) {
  RenderStyle style;
  style.width = picture.width;
  style.height = picture.height;
  style.lighting = picture.lighting;
  style.stage = robustBox(placesOf(scene));
  style.camera = picture.camera
                     ? *picture.camera
                     : fittedCamera(style.stage, static_cast<double>(picture.width) / picture.height);
  addWalls(picture.walls, scene.time, style);
  return style;
}

template<class Things> void addNames(const Things& things, std::vector<std::string>& names) {
  for (const auto& thing : things) names.push_back(thing.name);
}

/// Makes names unique among all objects, in all formats and frames.
void separateNames(RunScene& run) {
  std::set<std::string> used{"surface", "oriented", "oriented_curves", "particles", "camera"};
  const auto separate = [&](std::string& name) {
    const std::string own = name;
    for (int k = 2; !used.insert(usdName(name)).second; k++) name = fmt::format("{}_{}", own, k);
  };
  for (std::string& name : run.sheetNames) separate(name);
  for (ExportObject& object : run.obstacles) {
    separate(object.name);
    for (ComponentMesh& part : object.parts) part.name = object.name;
  }
  for (std::vector<std::string>* names : {&run.orientedNames, &run.sourceNames})
    for (std::string& name : *names) separate(name);
}

}  // namespace

std::shared_ptr<const RunScene> RunScenes::of(const fs::path& frame, std::vector<std::string>& warnings) {
  std::string text, name;
  {
    const std::lock_guard lock(hdf5);
    const H5File file = H5File::openToRead(frame.string(), Trailer::MustBe);
    if (file.has("/run/scene_toml")) text = file.readText("/run/scene_toml");
    if (file.has("/run/scene_name")) name = file.readText("/run/scene_name");
  }
  if (text.empty()) return nullptr;
  const std::lock_guard lock(making_);
  const auto [place, isNew] = byText_.try_emplace(text);
  if (!isNew) return place->second;
  try {
    auto made = std::make_shared<RunScene>();
    made->scene = sceneOfText(text, name);
    addNames(made->scene.sheets, made->sheetNames);
    addNames(made->scene.oriented, made->orientedNames);
    addNames(made->scene.bodies, made->sourceNames);
    addNames(made->scene.emitters, made->sourceNames);
    made->obstacles = obstaclesOf(made->scene, warnings);
    separateNames(*made);
    place->second = made;
    made->picture = jobOfScene(made->scene);
  } catch (const std::exception& error) {
    warnings.push_back(fmt::format("the scene in {} is not used{}: {}", frame.string(),
                                   place->second ? " for the camera" : "", error.what()));
  }
  return place->second;
}

FrameData readShared(const fs::path& frame, const GatherJob& job) {
  const std::lock_guard lock(job.scenes->hdf5);
  return readFrame(frame.string());
}

std::vector<Rgb> coloursOfColumn(const FrameColumn& column, std::size_t rows, const ExportOptions& options) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < rows; i++)
    if (const double v = column.value(i); std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  const ColourScale scale{
      options.min.value_or(low), options.max.value_or(high), colourMapNamed(options.map), {}, {}};
  const Palette palette = paletteOf(scale.map);
  std::vector<Rgb> colours(rows);
  for (std::size_t i = 0; i < rows; i++)
    colours[i] = palette[static_cast<std::size_t>(paletteIndex(scale, column.value(i)))];
  return colours;
}

std::vector<Vec3f> vectorsOf(const FrameColumn* column, std::size_t rows) {
  std::vector<Vec3f> values;
  if (!column || column->components != 3) return values;
  values.reserve(rows);
  for (std::size_t i = 0; i < rows; i++)
    values.push_back(single(Vec3d{column->value(i, 0), column->value(i, 1), column->value(i, 2)}));
  return values;
}

std::vector<float> numbersOf(const FrameColumn* column, std::size_t rows) {
  std::vector<float> values;
  if (!column || column->components != 1) return values;
  values.reserve(rows);
  for (std::size_t i = 0; i < rows; i++) values.push_back(static_cast<float>(column->value(i)));
  return values;
}

ExportScene gatherScene(const FrameGroup& group, const GatherJob& job, GatherNotes& notes) {
  ExportScene scene;
  scene.interval = job.interval;
  FrameInfo info;
  {
    const std::lock_guard lock(job.scenes->hdf5);
    info = readFrameInfo(group.first().string());
  }
  scene.time = info.time;
  scene.name = info.sceneName.empty() ? "run" : info.sceneName;
  const std::shared_ptr<const RunScene> stored = job.scenes->of(group.first(), notes.warnings);
  if (stored) {
    scene.spacing = stored->scene.spacing;
    if (scene.interval <= 0) scene.interval = stored->scene.output.every;
    scene.periodic = periodicSidesOf(stored->scene.domain);
    scene.sheetNames = stored->sheetNames;
    scene.orientedNames = stored->orientedNames;
    scene.sourceNames = stored->sourceNames;
  }
  const auto has = [&](unsigned content) { return (job.contents & content) != 0; };
  if (has(surfaceContent) && !group.surface.empty()) gatherSurface(group, job, scene, notes);
  if (has(orientedContent) && !group.oriented.empty()) gatherOriented(group, job, scene, notes);
  if (has(sheetContent) && !group.sheets.empty()) gatherSheets(group, job, scene, notes);
  if (has(particleContent) && !group.particles.empty()) gatherParticles(group, job, scene, notes);
  if (has(obstacleContent) && stored) gatherObstacles(*stored, scene, notes);
  scene.style = styleOf(stored ? stored->picture : FrameJob{}, scene);
  return scene;
}

}  // namespace thaw
