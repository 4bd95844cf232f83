// SPDX-License-Identifier: Apache-2.0
// Triangles in pictures of surfels: both sides, no gaps at folds.
#include <gtest/gtest.h>

#include "io/render/mesh_faces.hpp"
#include "io/render/surfels/render_surfels.hpp"

namespace thaw {
namespace {

constexpr Rgb red{200, 40, 40}, blue{40, 40, 200};

Image pictureOf(const FrameView& v, const Vec3d& from) {
  RenderStyle style;
  style.width = style.height = 120;
  style.camera.fitted = false;
  style.camera.from = from;
  style.camera.at = {0, 0, 0};
  return renderSurfels({v.positions, v.normals, v.radii, v.values, v.colours, v.components, v.faces}, style,
                       {SurfelPaint::Surface, 1.25f, 1});
}

Rgb middle(const Image& image) { return image.at(60, 60); }

TEST(MeshFaces, ShowTheVisibleSide) {
  FrameView v;
  const Vec3f up{0, 0, 1};
  addFace({FaceCorner{{-1, -1, 0}, up, red, blue}, {{1, -1, 0}, up, red, blue}, {{0, 1, 0}, up, red, blue}},
          v);
  const Rgb above = middle(pictureOf(v, {0, -0.5, 4})), below = middle(pictureOf(v, {0, -0.5, -4}));
  EXPECT_GT(above.r, 1.5 * above.b);
  EXPECT_GT(below.b, 1.5 * below.r);
}

/// A strip folded back on itself, seen across the fold. Its picture has no samples of the dark inside or the
/// background.
TEST(MeshFaces, LeaveNoGapsAtAFold) {
  std::vector<Vec3f> x;
  std::vector<std::array<std::uint32_t, 3>> t;
  for (int k = 0; k <= 40; k++) {
    const float s = 0.05f * static_cast<float>(k);  // 0 to 1 along the lower layer, and back along the upper
                                                    // one, 0.02 above it
    for (const float y : {-0.5f, 0.5f})
      x.push_back({0.5f - std::min(s, 2 - s), y, k < 20 ? -0.02f : k == 20 ? 0.0f : 0.02f});
    const auto n = static_cast<std::uint32_t>(2 * k);
    if (k > 0) t.push_back({n - 2, n, n - 1}), t.push_back({n - 1, n, n + 1});
  }
  const std::vector<Rgb> colours(x.size(), red);
  FrameView v;
  addMeshFaces({x, t, {}, colours}, v);
  const Image image = pictureOf(v, {-0.6, 0, 3});
  int bright = 0, all = 0;
  for (int j = 50; j < 70; j++)
    for (int i = 50; i < 70; i++) {
      all++;
      bright += image.at(i, j).r > 90 && image.at(i, j).r > 2 * image.at(i, j).b;
    }
  EXPECT_EQ(bright, all);
}

}  // namespace
}  // namespace thaw
