// SPDX-License-Identifier: Apache-2.0
// Drops of one and two particles in pictures.
#include "io/render/surfels/spray.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "tests/support/surface/surfel_samples.hpp"

using namespace thaw;

namespace {

constexpr double spacing = 0.1;

/// Adds a ball of `particles` cubes of the spacing, as component `label` at x along the x axis.
void addBall(SurfaceFrame& f, double particles, double x, std::uint64_t label) {
  SurfelSamples s;
  const double radius = std::cbrt(particles * 3 / (4 * std::numbers::pi)) * spacing;
  sampleBall(s, {x, 0, 0}, radius, 0.5 * spacing, label);
  for (std::size_t i = 0; i < s.size(); i++) {
    f.positions.push_back({s.positions[i].x, s.positions[i].y, s.positions[i].z});
    f.normals.push_back(s.normals[i]);
    f.radii.push_back(s.radii[i]);
    f.colours.push_back({1, 2, 3});
    f.ids.push_back(i);
    f.components.push_back(label);
  }
}

/// Adds a column with the component's label at each surfel.
void addLabels(SurfaceFrame& f) {
  FrameColumn c{"temperature", "K", Element::F32, 1, {}};
  c.bytes.resize(f.positions.size() * sizeof(float));
  for (std::size_t i = 0; i < f.positions.size(); i++) {
    const auto v = static_cast<float>(f.components[i]);
    std::memcpy(&c.bytes[i * sizeof(float)], &v, sizeof v);
  }
  f.columns.push_back(std::move(c));
}

SurfaceFrame threeBalls() {
  SurfaceFrame f;
  addBall(f, 1, 0, 5);
  addBall(f, 8, 1, 6);
  addBall(f, 2, 2, 7);
  addLabels(f);
  return f;
}

std::vector<std::uint32_t> rowsWith(const SurfaceFrame& f, std::uint64_t label) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < f.components.size(); i++)
    if (f.components[i] == label) rows.push_back(i);
  return rows;
}

}  // namespace

TEST(Spray, DropsOfOneAndTwoParticlesAreFound) {
  const std::vector<SprayDrop> drops = findSpray(threeBalls(), spacing);
  ASSERT_EQ(drops.size(), 2u);
  EXPECT_EQ(drops[0].component, 5u);
  EXPECT_EQ(drops[1].component, 7u);
  EXPECT_NEAR(drops[1].centre.x, 2, 0.01);
  EXPECT_NEAR(radiusOf(drops[1]), std::cbrt(2.0) * radiusOf(drops[0]), 0.005 * spacing);
  EXPECT_TRUE(findSpray(threeBalls(), 0).empty());
}

TEST(Spray, EllipsoidsKeepTheVolumeAndFollowTheMotion) {
  SurfaceFrame f = threeBalls();
  std::vector<SprayDrop> drops = findSpray(f, spacing);
  drops[0].velocity = {0, 3, 4};
  const std::size_t large = rowsWith(f, 6).size();
  const double exposure = 2 * radiusOf(drops[0]) / 5, stretch = stretchOf(drops[0], exposure);
  EXPECT_NEAR(stretch, 1.5, 1e-12);
  replaceSpray(f, drops, {Spray::Ellipsoids, spacing, exposure});
  EXPECT_EQ(rowsWith(f, 6).size(), large);
  ASSERT_GT(rowsWith(f, 5).size(), 30u);
  const double along = radiusOf(drops[0]) * stretch, across = radiusOf(drops[0]) / std::sqrt(stretch);
  for (const std::uint32_t i : rowsWith(f, 5)) {
    const Vec3d d = f.positions[i] - drops[0].centre, axis{0, 0.6, 0.8};
    const double z = dot(d, axis), r2 = dot(d, d) - z * z;
    EXPECT_NEAR(z * z / (along * along) + r2 / (across * across), 1, 1e-9);
    EXPECT_GT(f.normals[i].x * d.x + f.normals[i].y * d.y + f.normals[i].z * d.z, 0);
    EXPECT_FLOAT_EQ(static_cast<float>(f.columns[0].value(i)), 5);
    EXPECT_EQ(f.colours[i].g, 2);
  }
  for (const std::uint32_t i : rowsWith(f, 7))  // at rest
    EXPECT_NEAR(length(f.positions[i] - drops[1].centre), radiusOf(drops[1]), 1e-9);
}

/// A wall can flatten a drop, and evaporation can shrink it.
TEST(Spray, DropsHaveAtLeastTheVolumeOfTheirParticle) {
  SurfaceFrame f;
  addBall(f, 0.1, 0, 5);
  std::vector<SprayDrop> drops = findSpray(f, spacing);
  ASSERT_EQ(drops.size(), 1u);
  EXPECT_NEAR(radiusOf(drops[0]), std::cbrt(3 / (4 * std::numbers::pi)) * spacing, 1e-12);
  drops[0].least = 0.1 * spacing * spacing * spacing;
  const double radius = radiusOf(drops[0]);
  EXPECT_NEAR(radius, std::cbrt(0.3 / (4 * std::numbers::pi)) * spacing, 0.005 * spacing);
  replaceSpray(f, drops, {Spray::Spheres, spacing, 0});
  for (const Vec3d& x : f.positions) EXPECT_NEAR(length(x - drops[0].centre), radius, 1e-9);
}

TEST(Spray, DropsAreHiddenOrKept) {
  SurfaceFrame f = threeBalls();
  const std::size_t all = f.positions.size(), large = rowsWith(f, 6).size();
  replaceSpray(f, findSpray(f, spacing), {Spray::Surfels, spacing, 0});
  EXPECT_EQ(f.positions.size(), all);
  replaceSpray(f, findSpray(f, spacing), {Spray::Hide, spacing, 0});
  EXPECT_EQ(f.positions.size(), large);
  EXPECT_EQ(f.columns[0].bytes.size(), large * sizeof(float));
  EXPECT_EQ(sprayNamed("hide"), Spray::Hide);
  EXPECT_THROW(sprayNamed("mist"), std::invalid_argument);
}
