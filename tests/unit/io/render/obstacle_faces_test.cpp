// SPDX-License-Identifier: Apache-2.0
#include "io/render/obstacle_faces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "io/render/light/glass_walk.hpp"
#include "io/render/scene_job.hpp"
#include "io/scene/read_scene.hpp"
#include "io/surface_mesh/obstacle_mesh.hpp"

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

// The floor right of the box, in its shadow if the sun is on the left.
TEST(ObstacleFaces, GlassCastsPaleShadowsOfItsColour) {
  const auto floorLight = [](const std::string& look, double sun) {
    Scene scene = boxScene(look);
    scene.output.background = 0x808080u;
    scene.output.sun = Vec3d{sun, 0, 1};
    const Image image = pictureAt(scene, 0);
    std::array<double, 3> sum{};
    for (int y = 80; y < 94; y++)
      for (int x = 124; x < 136; x++) {
        const Rgb c = image.at(x, y);
        sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
      }
    return sum;
  };
  const auto open = floorLight("glass", 1), solid = floorLight("solid", -1), glass = floorLight("glass", -1);
  EXPECT_GT(glass[0], 1.1 * solid[0]);
  EXPECT_GT(open[0], 1.01 * glass[0]);
  EXPECT_GT(glass[0] / open[0], 1.1 * glass[1] / open[1]) << "the glass is red";
}

TEST(GlassShade, LightPassesBesideGlassAndInPartThroughIt) {
  RenderStyle style;
  Shape ball;
  ball.kind = ShapeKind::Sphere, ball.radius = 0.5;
  style.glasses.push_back({makeSignedDistance(ball, {}), identity3<double>(), {0, 0, 2}, {1, 0.0625f, 1}});
  const GlassShade shade(glassWalks(style), {{0, 0, 1}}, 0);
  EXPECT_EQ(shade.at({0.6f, 0, 0}), (Light{1, 1, 1}));
  EXPECT_EQ(shade.at({0, 0, 3}), (Light{1, 1, 1})) << "the glass is below";
  const Light middle = shade.at({0, 0, 0}), rim = shade.at({0.49f, 0, 0});
  EXPECT_NEAR(middle.x, 0.95 * 0.95, 1e-3);         // two faces reflect 5 % each
  EXPECT_NEAR(middle.y, 0.95 * 0.95 * 0.25, 1e-3);  // and each passes the fourth root of the colour
  EXPECT_LT(rim.x, 0.8f * middle.x);
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

// Rounding must not move a plane at a side out of the domain.
TEST(ObstacleMeshes, APlaneAtASideEndsAtTheOtherSides) {
  Domain domain;
  for (const double low : {-0.2, -0.3, -0.17, -0.013, 0.1, 0.7})
    for (int axis = 0; axis < 3; axis++) {
      domain.min = {low, low, low}, domain.max = {low + 0.55, low + 0.71, low + 1.13};
      Obstacle plane;
      plane.shape.kind = ShapeKind::HalfSpace;
      plane.shape.point = {}, plane.shape.normal = {};
      plane.shape.point[axis] = low, plane.shape.normal[axis] = 1;
      for (const Vec3d& x : obstacleMesh(plane, domain).mesh.vertices)
        for (int a = 0; a < 3; a++)
          EXPECT_TRUE(x[a] > low - 1e-6 && x[a] < domain.max[a] + 1e-6) << low << axis;
    }
}
