// SPDX-License-Identifier: Apache-2.0
#include "io/render/particles/render.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace thaw;

namespace {

RenderStyle smallStyle() {
  RenderStyle style;
  style.width = 160;
  style.height = 120;
  style.camera.fitted = false;
  style.camera.from = {0, -10, 2};
  style.camera.at = {0, 0, 0.5};
  style.camera.fieldOfView = 0.5;
  style.colours = {0, 1, ColourMap::Ember, "x", "1"};
  style.stage.add({-1, -1, 0});
  style.stage.add({1, 1, 1});
  return style;
}

int difference(Rgb a, Rgb b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); }
int brightness(Rgb a) { return a.r + a.g + a.b; }

Image picture(const std::vector<Vec3f>& x, const std::vector<float>& v, float radius,
              const RenderStyle& style) {
  return render({x, v, std::span<const float>(&radius, 1)}, style);
}

}  // namespace

TEST(Render, TheNearerSphereHidesTheFartherOneInEitherOrder) {
  const RenderStyle style = smallStyle();
  const Vec3f front{0, -1, 0.5f}, back{0, 1, 0.5f};
  const Image a = picture({front, back}, {1, 0}, 0.4f, style),
              b = picture({back, front}, {0, 1}, 0.4f, style);
  EXPECT_EQ(a.pixels, b.pixels);
  const Image high = picture({front}, {1}, 0.4f, style), low = picture({front}, {0}, 0.4f, style);
  EXPECT_LT(difference(a.at(80, 60), high.at(80, 60)), 40);
  EXPECT_GT(difference(a.at(80, 60), low.at(80, 60)), 150);
}

TEST(Render, ASphereIsWhereTheCameraProjectsIt) {
  const RenderStyle style = smallStyle();
  const Image none = picture({}, {}, 0.2f, style), one = picture({{0.5f, 0, 0.5f}}, {1}, 0.2f, style);
  float x, y;
  const View view = viewOf(style.camera, style.width, style.height);
  const float z = view.project({0.5f, 0, 0.5f}, x, y), radius = view.focal * 0.2f / z;
  int changed = 0;
  for (int j = 0; j < style.height; j++)
    for (int i = 0; i < style.width; i++) {
      if (one.at(i, j) == none.at(i, j)) continue;
      changed++;
      EXPECT_LE(std::hypot(static_cast<float>(i) + 0.5f - x, static_cast<float>(j) + 0.5f - y), radius + 1);
    }
  EXPECT_NEAR(changed, 3.14159 * radius * radius, 0.25 * 3.14159 * radius * radius);
}

TEST(Render, FloorShowsShadowsAndHidesParticlesBelow) {
  RenderStyle style = smallStyle();
  style.floors.push_back({{0, 0, 0}, {0, 0, 1}});
  const Image empty = picture({}, {}, 0.2f, style), ball = picture({{0, 0, 0.6f}}, {1}, 0.3f, style),
              below = picture({{0, 0, -0.6f}}, {1}, 0.3f, style);
  int darker = 0;
  for (std::size_t i = 0; i < empty.pixels.size(); i++)
    darker += brightness(ball.pixels[i]) < brightness(empty.pixels[i]) - 60 &&
              difference(ball.pixels[i], {0, 0, 0}) > 0;
  EXPECT_GT(darker, 50);
  const View view = viewOf(style.camera, style.width, style.height);
  float x, y;
  view.project({0, 0, -0.6f}, x, y);
  EXPECT_LT(difference(below.at(static_cast<int>(x), static_cast<int>(y)),
                       empty.at(static_cast<int>(x), static_cast<int>(y))),
            30);
}

TEST(Render, OmitsNonFiniteParticlesAndThoseBehindTheCamera) {
  const RenderStyle style = smallStyle();
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Image none = picture({}, {}, 0.2f, style);
  EXPECT_EQ(picture({{nan, 0, 0}, {inf, 0, 0}, {0, -30, 0}}, {1, nan, 0}, 0.2f, style).pixels, none.pixels);
}

TEST(Render, IsTheSamePictureEachTime) {
  std::vector<Vec3f> x;
  std::vector<float> v;
  for (int i = 0; i < 1000; i++) {
    x.push_back({static_cast<float>(i % 10) * 0.1f - 0.5f, static_cast<float>(i / 10 % 10) * 0.1f - 0.5f,
                 static_cast<float>(i / 100) * 0.1f});
    v.push_back(static_cast<float>(i) / 1000);
  }
  RenderStyle style = smallStyle();
  style.floors.push_back({});
  EXPECT_EQ(picture(x, v, 0.065f, style).pixels, picture(x, v, 0.065f, style).pixels);
}

TEST(Render, RefusesSpansThatDoNotFit) {
  const RenderStyle style = smallStyle();
  EXPECT_THROW(picture({{0, 0, 0}, {1, 0, 0}}, {1}, 0.1f, style), std::invalid_argument);
  const std::vector<Vec3f> x{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<float> radii{0.1f, 0.1f};
  EXPECT_THROW(render({x, {}, radii}, style), std::invalid_argument);
  RenderStyle wide = style;
  wide.width = 0;
  EXPECT_THROW(picture({}, {}, 0.1f, wide), std::invalid_argument);
}

TEST(View, TheFittedCameraSeesTheWholeBox) {
  for (const Vec3d& size : {Vec3d{1, 1, 1}, Vec3d{5, 0.1, 0.1}, Vec3d{0.1, 0.1, 9}, Vec3d{0, 0, 0}}) {
    ViewBox box;
    box.add({3, 4, 5});
    box.add(Vec3d{3, 4, 5} + size);
    const View view = viewOf(fittedCamera(box, 4.0 / 3), 400, 300);
    for (int corner = 0; corner < 8; corner++) {
      float x, y;
      const Vec3d p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                    corner & 4 ? box.max.z : box.min.z};
      const float z = view.project(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}, x, y);
      EXPECT_GT(z, 0);
      EXPECT_TRUE(x >= 0 && x <= 400 && y >= 0 && y <= 300) << x << ' ' << y;
    }
  }
}
