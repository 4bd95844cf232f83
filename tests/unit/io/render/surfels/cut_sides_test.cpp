// SPDX-License-Identifier: Apache-2.0
// Surfaces that are cut at periodic sides: caps, and straight rims in pictures.
#include "io/render/surfels/cut_sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/hash_random.hpp"
#include "io/render/surfels/render_surfels.hpp"

using namespace thaw;

namespace {

constexpr double apart = 0.05;  // m, between surfels
constexpr double pi = std::numbers::pi;

const PeriodicSides alongX{{true, false, false}, {0, -1, -1}, {1, 2, 2}};

void addSurfel(SurfaceFrame& f, const Vec3d& x, const Vec3d& n) {
  f.positions.push_back(x);
  f.normals.push_back(single(n));
  f.radii.push_back(static_cast<float>(apart));
  f.colours.push_back({200, 100, 50});
  f.ids.push_back(f.ids.size());
  f.components.push_back(7);
}

double noise(std::size_t k) { return apart * (randomUniform(5, Purpose::Test, k) - 0.5); }

/// A jet along the periodic axis, with its surfels at irregular distances from the sides.
SurfaceFrame jet(double radius) {
  SurfaceFrame f;
  const int around = static_cast<int>(2 * pi * radius / apart);
  for (int ring = 0; ring < 20; ring++)
    for (int k = 0; k < around; k++) {
      const double angle = 2 * pi * (k + 0.5 * (ring % 2)) / around;
      const Vec3d n{0, std::cos(angle), std::sin(angle)};
      const double x = (ring + 0.5) * apart + noise(f.ids.size());
      addSurfel(f, Vec3d{x - std::floor(x), 0, 0} + radius * n, n);
    }
  return f;
}

/// A layer across two periodic axes, of unit length and this height.
SurfaceFrame layer(double height) {
  SurfaceFrame f;
  for (int i = 0; i < 20; i++)
    for (int j = 0; j < 20; j++)
      for (const double side : {-1.0, 1.0})
        addSurfel(f, {(i + 0.5) * apart, (j + 0.5) * apart, 0.5 * side * height}, {0, 0, side});
  return f;
}

/// Area of the caps by direction: -x, x, -y, y, -z, z.
std::array<double, 6> areaOfCaps(const SurfaceFrame& f, const CutSides& cut) {
  std::array<double, 6> area{};
  for (const auto& [a, b, c] : cut.faces) {
    const Vec3d n = 0.5 * cross(f.positions[b] - f.positions[a], f.positions[c] - f.positions[a]);
    for (int k = 0; k < 3; k++) {
      area[2 * static_cast<std::size_t>(k)] += std::max(0.0, -n[k]);
      area[2 * static_cast<std::size_t>(k) + 1] += std::max(0.0, n[k]);
    }
    EXPECT_GT(dot(single(n), f.normals[a]), 0);
  }
  return area;
}

/// Returns the right rim of a jet in a picture: the last column with another colour than the background, for
/// rows across the jet.
std::vector<int> rightRim(SurfaceFrame f, bool cut) {
  RenderStyle style;
  style.width = 300, style.height = 200, style.samples = 1;
  style.stage.add({0, -0.4, -0.4}), style.stage.add({1, 0.4, 0.4});
  style.camera.from = {0.5, -30, 0}, style.camera.at = {0.5, 0, 0}, style.camera.fieldOfView = 0.04;
  CutSides sides;
  if (cut) sides = closeCutSides(f, {{7, 1}}, alongX);
  std::vector<Vec3f> positions;
  for (const Vec3d& x : f.positions) positions.push_back(single(x));
  const std::vector<std::uint32_t> components(f.components.begin(), f.components.end());
  SurfelInput in{positions, f.normals, f.radii, {}, {}, components, sides.faces};
  in.cutAxes = sides.axes, in.sides = alongX;
  const Image image = renderSurfels(in, style, {}), none = renderSurfels({}, style, {});
  std::vector<int> rim;
  for (int y = 70; y < 130; y++) {
    int last = -1;
    for (int x = 0; x < style.width; x++)
      if (!(image.at(x, y) == none.at(x, y))) last = x;
    rim.push_back(last);
  }
  return rim;
}

}  // namespace

TEST(CutSides, CapsOfAJetAreDiscs) {
  SurfaceFrame f = jet(0.3);
  const std::array<double, 6> area = areaOfCaps(f, closeCutSides(f, {{7, 1}}, alongX));
  for (const std::size_t side : {0u, 1u}) EXPECT_NEAR(area[side] / (pi * 0.09), 1, 0.02);
  for (const std::size_t side : {2u, 3u, 4u, 5u}) EXPECT_EQ(area[side], 0);
}

TEST(CutSides, CapsOfALayerMeetInItsCorners) {
  SurfaceFrame f = layer(0.2);
  const PeriodicSides sides{{true, true, false}, {0, 0, -1}, {1, 1, 2}};
  const std::array<double, 6> area = areaOfCaps(f, closeCutSides(f, {{7, 3}}, sides));
  for (const std::size_t side : {0u, 1u, 2u, 3u}) EXPECT_NEAR(area[side], 0.2, 1e-6);
}

TEST(CutSides, RowsKeepTheirOrderAndOtherComponentsTheirRows) {
  SurfaceFrame f = jet(0.3);
  const SurfaceFrame before = f;
  EXPECT_TRUE(closeCutSides(f, {{8, 1}}, alongX).faces.empty());
  EXPECT_EQ(f.positions, before.positions);
  const CutSides cut = closeCutSides(f, {{7, 1}}, alongX);
  EXPECT_EQ(cut.axes.size(), f.positions.size());
  EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.end(), f.positions.begin()));
  for (const auto& face : cut.faces)
    for (const std::uint32_t row : face) EXPECT_EQ(f.components[row], capComponent);
}

TEST(CutSides, RimsAreStraight) {
  const auto spread = [](const std::vector<int>& rim) {
    return *std::max_element(rim.begin(), rim.end()) - *std::min_element(rim.begin(), rim.end());
  };
  EXPECT_GT(spread(rightRim(jet(0.3), false)), 3);  // scallops of discs
  EXPECT_LE(spread(rightRim(jet(0.3), true)), 1);
}
