// SPDX-License-Identifier: Apache-2.0
// Solid walls that are too thin to hold liquid are reported, with their place.
#include <gtest/gtest.h>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

/// A glass whose wall has this many spacings, with water in it.
Scene glassOfWater(double wall, bool water = true) {
  Scene s;
  s.spacing = 0.01;
  s.domain.min = {-0.2, -0.2, -0.05};
  s.domain.max = {0.2, 0.2, 0.3};
  s.materials.resize(2);
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e5, 0};
  s.materials[1].name = "water";
  Body glass, drink;
  glass.name = "glass";
  glass.where = {"glass.toml", 9, 1};
  glass.shape.kind = ShapeKind::Glass;
  glass.shape.radius = 0.1;
  glass.shape.height = 0.2;
  glass.shape.thickness = wall * s.spacing;
  s.bodies.push_back(glass);
  drink.name = "drink";
  drink.material = 1;
  drink.shape.size = {0.06, 0.06, 0.06};
  drink.shape.move = {0, 0, 0.1};
  if (water) s.bodies.push_back(drink);
  return s;
}

std::string wallWarning(const Scene& s) {
  const Simulation run(s);
  for (const SceneWarning& w : run.report.warnings)
    if (w.text.find("walls thinner than") != std::string::npos) return w.where.file + " " + w.text;
  return "";
}

}  // namespace

TEST(ThinWalls, BelowTwoSpacingsAreReportedWithTheirPlace) {
  const std::string one = wallWarning(glassOfWater(1));
  EXPECT_EQ(one.find("glass.toml body 'glass': "), 0u) << one;
  EXPECT_NE(one.find("about 0.01 m at ("), std::string::npos) << one;
  EXPECT_NE(one.find("reduce the spacing to 0.005 m or less"), std::string::npos) << one;
  EXPECT_NE(wallWarning(glassOfWater(1.5)), "");
  EXPECT_EQ(wallWarning(glassOfWater(2.1)), "");
}

TEST(ThinWalls, AreNotReportedWithoutALiquid) { EXPECT_EQ(wallWarning(glassOfWater(1, false)), ""); }

}  // namespace thaw::test
