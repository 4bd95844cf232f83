// SPDX-License-Identifier: Apache-2.0
#include "io/render/scene_job.hpp"

#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"

using namespace thaw;

namespace {

const char* wax =
    "[material.wax]\ndensity = 900\nyoung = \"60 kPa\"\nconductivity = 0.25\nheat_capacity = 2000\nmelts = "
    "[\"52 degC\", \"56 degC\"]\n";
const char* pot = R"(include = "wax.toml"
title = "A pot of wax"
spacing = "2 mm"
end = "1 s"
[domain]
min = [-1, -1, 0]
max = [1, 1, 1]
[[body]]
name = "ball"
sphere = { radius = "3 cm" }
material = "wax"
[output]
every = "40 ms"
colour_min = 293.15
)";

SceneFiles files() {
  SceneFiles f;
  f.main = "some/pot.toml";
  f.texts = {{"some/pot.toml", pot}, {"some/wax.toml", wax}};
  return f;
}

}  // namespace

TEST(SceneJob, SceneTextRoundTripsWithIncludesAndOverrides) {
  const Scene scene = readScene(files(), {"spacing=\"3 mm\""});
  const Scene back = sceneOfText(scene.text, "pot");
  EXPECT_EQ(back.title, "A pot of wax");
  EXPECT_DOUBLE_EQ(back.spacing, 0.003);
  EXPECT_EQ(back.materials.at(0).density, 900);
  EXPECT_EQ(back.text, scene.text);
  EXPECT_THROW(sceneOfText(scene.text, "other"), SceneErrors);
  EXPECT_THROW(sceneOfText("", "pot"), SceneErrors);
  EXPECT_THROW(sceneOfText("# ---- pot.toml\nspacing = [", "pot"), SceneErrors);
}

TEST(SceneJob, DropsHaveTheLookOfTheScene) {
  EXPECT_EQ(jobOfScene(readScene(files(), {})).spray, Spray::Ellipsoids);
  EXPECT_EQ(jobOfScene(readScene(files(), {"output.spray=\"hide\""})).spray, Spray::Hide);
  EXPECT_EQ(jobOfScene(readScene(files(), {"output.spray=\"spheres\""})).spray, Spray::Spheres);
  EXPECT_THROW(readScene(files(), {"output.spray=\"mist\""}), SceneErrors);
}

TEST(SceneJob, UsesTheSettingsOfTheScene) {
  Scene scene = readScene(files(), {});
  scene.domain.side[2][0] = Side::Wall;
  Obstacle glass;
  glass.shape.kind = ShapeKind::Glass;
  glass.temperature = 400;  // switches heat on
  glass.until = 0.5;
  glass.motion = {{0, {}, {}}, {1, {0, 0, 2}, {}}};
  Obstacle slope;
  slope.shape.kind = ShapeKind::HalfSpace;
  slope.shape.normal = {0.6, 0, 0.8};
  slope.shape.point = {0, 0, 0.25};
  scene.obstacles = {glass, slope};
  const FrameJob job = jobOfScene(scene);
  EXPECT_EQ(job.field, "temperature");
  EXPECT_EQ(job.title, scene.title);
  EXPECT_NEAR(job.min.value(), 293.15, 1e-9);
  EXPECT_FALSE(job.max);
  EXPECT_FALSE(job.camera);
  EXPECT_FLOAT_EQ(job.spacing, 0.002f);

  RenderStyle early, late;
  addWalls(job.walls, 0.25, early);
  addWalls(job.walls, 0.75, late);
  ASSERT_EQ(early.glasses.size(), 1u);
  EXPECT_DOUBLE_EQ(early.glasses[0].move.z, 0.5);
  EXPECT_TRUE(late.glasses.empty());
  ASSERT_EQ(early.floors.size(), 2u);  // the slope and the domain's side
  EXPECT_NEAR(dot(early.floors[0].normal, Vec3d{0.6, 0, 0.8}), 1, 1e-12);
  EXPECT_NEAR(dot(early.floors[0].point - Vec3d{0, 0, 0.25}, Vec3d{0.6, 0, 0.8}), 0, 1e-12);
  EXPECT_NEAR(early.floors[1].point.z, 0, 1e-12);

  scene.output.camera = {false, {1, 2, 3}, {0, 0, 0}, 0.3};
  scene.output.colour = "speed";
  EXPECT_EQ(jobOfScene(scene).camera->from.z, 3);
  EXPECT_EQ(jobOfScene(scene).field, "speed");
}
