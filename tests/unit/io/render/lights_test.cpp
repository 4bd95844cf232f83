// SPDX-License-Identifier: Apache-2.0
// Lights and background of pictures.
#include <gtest/gtest.h>

#include "io/render/particles/render.hpp"
#include "io/render/surfels/render_surfels.hpp"
#include "tests/support/surface/surfel_samples.hpp"

using namespace thaw;

namespace {

RenderStyle styleOfBall() {
  RenderStyle style;
  style.width = 160, style.height = 120;
  style.camera.fitted = false;
  style.camera.from = {0, -4, 0.5}, style.camera.at = {0, 0, 0.5};
  style.camera.fieldOfView = 0.5;
  style.spacing = 0.04f;
  return style;
}

/// Pictures of a white ball of radius 0.5, by its surfels and by particles.
std::vector<Image> picturesOf(const RenderStyle& style) {
  SurfelSamples s;
  sampleBall(s, {0, 0, 0.5}, 0.5, 0.04, 1);
  const std::vector<Rgb> white(s.size(), Rgb{255, 255, 255});
  SurfelInput surfels;
  surfels.positions = s.positions, surfels.normals = s.normals, surfels.radii = s.radii;
  surfels.colours = white;
  const std::vector<float> radius{0.04f};
  return {renderSurfels(surfels, style, {SurfelPaint::Surface}), render({s.positions, {}, radius}, style)};
}

}  // namespace

TEST(PictureLights, ALightLikeTheSunGivesTheSamePicture) {
  RenderStyle sunny = styleOfBall(), lit = sunny;
  sunny.floors.push_back({}), lit.floors.push_back({});
  sunny.lighting.sun = Vec3d{1, -1, 2};
  lit.lighting.lights.push_back({{1, -1, 2}, {1, 1, 1}, 0.14});
  const std::vector<Image> a = picturesOf(sunny), b = picturesOf(lit);
  for (std::size_t k = 0; k < a.size(); k++) EXPECT_TRUE(a[k].pixels == b[k].pixels) << k;
}

TEST(PictureLights, EachLightHasItsSideAndColour) {
  RenderStyle style = styleOfBall();
  style.lighting.ambient = 0;
  style.lighting.background = Rgb{0, 0, 0};
  style.lighting.lights.push_back({{-1, -0.2, 0}, {1, 0, 0}, 0.1});
  style.lighting.lights.push_back({{1, -0.2, 0}, {0, 0, 1}, 0.4});
  for (const Image& picture : picturesOf(style)) {
    const Rgb left = picture.at(56, 60), right = picture.at(104, 60);
    EXPECT_GT(left.r, left.b + 60);
    EXPECT_GT(right.b, right.r + 60);
    EXPECT_LT(picture.at(80, 5).b, 3);  // the background
  }
}

TEST(PictureLights, LightsOfAFloorCastShadowsToBothSides) {
  RenderStyle style = styleOfBall();
  style.camera.from = {0, -4, 4};
  style.floors.push_back({});
  style.lighting.ambient = 0;
  const auto redOnFloor = [&](int x) { return int{picturesOf(style)[0].at(x, 66).r}; };
  style.lighting.lights.push_back({{-1, 0, 0.7}, {1, 1, 1}, 0.05});
  const int shadow = redOnFloor(112), open = redOnFloor(40);
  EXPECT_LT(shadow + 60, open);
  style.lighting.lights.push_back({{1, 0, 0.7}, {1, 1, 1}, 0.05});
  EXPECT_GT(redOnFloor(112), shadow + 60);
}

TEST(PictureLights, TheBackgroundIsAGradient) {
  RenderStyle style = styleOfBall();
  style.camera.fieldOfView = 1.6;
  style.lighting.background = Rgb{200, 100, 50};
  style.lighting.backgroundTop = Rgb{10, 20, 200};
  for (const Image& picture : picturesOf(style)) {
    EXPECT_TRUE(picture.at(2, 118) == (Rgb{200, 100, 50}));
    EXPECT_LT(picture.at(80, 0).r + 30, 200);
    EXPECT_GT(picture.at(80, 0).b, 80);
  }
}
