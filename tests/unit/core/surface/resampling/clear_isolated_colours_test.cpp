// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/clear_isolated_colours.hpp"

#include <gtest/gtest.h>

#include "core/surface/resampling/birth_colours.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

constexpr std::uint32_t red = 0x3040e0, blue = 0xe05030;

/// A sheet of 30 x 30 surfels, coloured by row and column.
struct Sheet : SurfelRig {
  static Scene scene() {
    Scene s = surfelScene(0.1);
    s.materials.resize(2);
    s.materials[0].colour = red, s.materials[1].colour = blue;
    s.bodies.resize(2);
    s.bodies[1].material = 1;
    return s;
  }
  template<class Colour> explicit Sheet(Colour&& colour) : SurfelRig(scene()) {
    for (int j = 0; j < 30; j++)
      for (int k = 0; k < 30; k++) {
        add({0.1 * j - 1.5 + 0.05 * (k % 2), 0.087 * k - 1.3, 0.01}, {0, 0, 1});
        surfels().colour[surfels().owned - 1] = colour(j, k);
        surfels().liquid[surfels().owned - 1] = 1;
      }
    placeRows(world.surface.grid, ranks->halos().surfels, surfels(), world.surface.surfelCells, tools.sort);
  }
  void clear() { clearIsolatedColours(world.scene, world.surface, ranks->halos(), tools); }
  std::vector<std::uint32_t> colours() {
    return {surfels().colour.data(), surfels().colour.data() + surfels().owned};
  }
  std::int64_t count(std::uint32_t c) {
    const auto all = colours();
    return std::count(all.begin(), all.end(), c);
  }
};

TEST(ClearIsolatedColours, ReplacesOnlyIsolatedColours) {
  // single surfels, and a pair
  const auto isolated = [](int j, int k) {
    return (j % 5 == 2 && k % 5 == 2) || (j == 14 && k == 10) ? red : blue;
  };
  Sheet sheet(isolated);
  EXPECT_EQ(sheet.count(red), 37);
  sheet.clear();
  EXPECT_EQ(sheet.count(red), 0);
  // the mean around, including other isolated colours
  for (const std::uint32_t c : sheet.colours())
    EXPECT_LT(std::abs(static_cast<int>(c & 255) - static_cast<int>(blue & 255)), 60);
  Sheet half([](int j, int) { return j < 15 ? red : blue; }),
      spot([](int j, int k) { return std::hypot(j - 14, k - 14) < 3 ? red : blue; });
  for (Sheet* s : {&half, &spot}) {
    const auto before = s->colours();
    s->clear();
    EXPECT_EQ(s->colours(), before);
  }
  Sheet solid(isolated);
  for (std::size_t i = 0; i < solid.surfels().owned; i++) solid.surfels().liquid[i] = 0;
  const auto before = solid.colours();
  solid.clear();
  EXPECT_EQ(solid.colours(), before);
}

/// A newborn takes the mean colour of its neighbours, or that of its material without any.
TEST(ClearIsolatedColours, BirthsHaveTheMeanColourOfTheirNeighbours) {
  Sheet half([](int j, int) { return j < 15 ? red : blue; });
  SurfaceParticles& p = half.world.surface.particles;
  p.resize(1, 0);
  p.body[0] = 0;
  p.position[0] = {0, 0, 0};
  std::vector<SurfelRow> rows;
  for (const Vec3d& x : {Vec3d{-0.3, 0, 0}, Vec3d{0.3, 0, 0}, Vec3d{-0.025, 0, 0}, Vec3d{0, 0, 2}}) {
    SurfelRow r;
    r.position = x;
    r.component = 1;
    r.particle = 0;
    r.colour = 0x010203;
    rows.push_back(r);
  }
  inheritColours(half.world.scene, half.world.surface, half.ranks->halos(), half.tools, rows);
  EXPECT_EQ(rows[0].colour, red);
  EXPECT_EQ(rows[1].colour, blue);
  for (int c = 0; c < 3; c++)
    EXPECT_NEAR(static_cast<double>(rows[2].colour >> 8 * c & 255),
                0.5 * static_cast<double>((red >> 8 * c & 255) + (blue >> 8 * c & 255)), 40);
  EXPECT_EQ(rows[3].colour, 0x010203u);
}

}  // namespace
}  // namespace thaw
