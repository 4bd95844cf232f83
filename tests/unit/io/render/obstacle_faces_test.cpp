// SPDX-License-Identifier: Apache-2.0
#include "io/render/obstacle_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/render/scene_job.hpp"
#include "io/scene/read_scene.hpp"

using namespace thaw;

namespace {

/// A red box on a floor, far from a few particles, which moves by 1 m within a second and ends at 3 s.
Scene boxScene(const std::string& look) {
  SceneFiles files;
  files.main = "box.toml";
  files.texts["box.toml"] = R"(spacing = "5 cm"
end = "4 s"
[domain]
min = [-2, -2, -0.1]
max = [4, 2, 2]
[material.water]
[[body]]
box = { size = [0.2, 0.2, 0.2] }
place = { move = [-1, 0, 0.1] }
material = "water"
[[obstacle]]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[[obstacle]]
box = { size = [0.6, 0.6, 0.6] }
place = { move = [0, 0, 0.3] }
motion = [{ time = 0 }, { time = 1, move = [1, 0, 0] }]
until = 3
colour = "#d02010"
look = ")" + look + "\"\n[output]\nevery = 1\nbackground = \"#101820\"\nsun = [0, -1, 1]\n" +
                            "camera = { from = [0, -5, 2], at = [0, 0, 0.3], field_of_view = 0.5 }\n";
  return readScene(files, {});
}

FrameView particles(double time) {
  FrameView view;
  view.time = time;
  for (int k = 0; k < 8; k++)
    view.positions.push_back({-1.0f + 0.05f * static_cast<float>(k & 1),
                              0.05f * static_cast<float>(k >> 1 & 1),
                              0.05f + 0.05f * static_cast<float>(k >> 2)});
  return view;
}

/// The picture of the scene at a time.
Image pictureAt(const Scene& scene, double time) {
  FrameJob job = jobOfScene(scene);
  job.frames = {"one.hdf"};
  job.out = testing::TempDir() + "/obstacle_faces_" +
            testing::UnitTest::GetInstance()->current_test_info()->name();
  job.field = "";
  job.width = 200, job.height = 150;
  Image kept;
  job.over = [&](Image& image, const RenderStyle&) { kept = image; };
  renderFrames(job, [&](const std::filesystem::path&, const std::string&) { return particles(time); });
  return kept;
}

bool red(const Rgb& c) { return c.r > 2 * c.g && c.r > 2 * c.b && c.r > 60; }

int redPixels(const Image& image) {
  int count = 0;
  for (const Rgb& c : image.pixels) count += red(c);
  return count;
}

}  // namespace

TEST(ObstacleFaces, SolidObstaclesAreOpaqueInTheirColourAndGlassIsNot) {
  EXPECT_GT(redPixels(pictureAt(boxScene("solid"), 0)), 300);
  EXPECT_EQ(redPixels(pictureAt(boxScene("glass"), 0)), 0);
}

TEST(ObstacleFaces, SolidObstaclesMoveAndDisappear) {
  const Image before = pictureAt(boxScene("solid"), 0), after = pictureAt(boxScene("solid"), 1),
              gone = pictureAt(boxScene("solid"), 3.5);
  EXPECT_TRUE(red(before.at(100, 75)));
  EXPECT_FALSE(red(after.at(100, 75)));
  EXPECT_GT(redPixels(after), 100);
  EXPECT_EQ(redPixels(gone), 0);
}

// The sun is before the box, so its shadow falls on the floor behind, and to neither side.
TEST(ObstacleFaces, SolidObstaclesCastShadowsAwayFromTheSun) {
  Scene scene = boxScene("solid");
  scene.output.sun = Vec3d{-1, 0, 1};
  const Image left = pictureAt(scene, 0);
  scene.output.sun = Vec3d{1, 0, 1};
  const Image right = pictureAt(scene, 0);
  const auto bright = [](const Rgb& c) { return c.r + c.g + c.b; };
  int darker = 0, brighter = 0;  // floor right of the box, in the light of a sun from the left
  for (int y = 80; y < 94; y++)
    for (int x = 119; x < 136; x++) {
      if (red(left.at(x, y)) || red(right.at(x, y))) continue;
      darker += bright(left.at(x, y)) < bright(right.at(x, y));
      brighter += bright(left.at(x, y)) > bright(right.at(x, y));
    }
  EXPECT_GT(darker, 100);
  EXPECT_LT(brighter, darker / 4);
}

TEST(ObstacleFaces, TheBackgroundHasItsColour) {
  const Rgb corner = pictureAt(boxScene("glass"), 0).at(2, 2);
  EXPECT_NEAR(corner.r, 0x10, 3);
  EXPECT_NEAR(corner.g, 0x18, 3);
  EXPECT_NEAR(corner.b, 0x20, 3);
}

TEST(ObstacleFaces, TrianglesAreSmallAndKeepTheArea) {
  const std::vector<DrawnObstacle> all = solidObstacles(jobOfScene(boxScene("solid")).walls);
  ASSERT_EQ(all.size(), 1u);  // not the plane
  double area = 0;
  for (const auto& t : all[0].triangles) {
    const Vec3d &x = all[0].places[t[0]], a = all[0].places[t[1]] - x, b = all[0].places[t[2]] - x;
    area += 0.5 * length(cross(a, b));
    EXPECT_LT(length(a), 0.6 / 40 + 1e-9);
  }
  EXPECT_NEAR(area, 6 * 0.36, 1e-9);
  // Faces share vertices, and cast their shadows as a few large triangles.
  EXPECT_LT(all[0].places.size(), all[0].triangles.size());
  EXPECT_LE(all[0].casters.size(), 100u);
}
