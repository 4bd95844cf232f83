// SPDX-License-Identifier: Apache-2.0
#include "core/scene/buoyancy.hpp"
#include "core/scene/temperature_table.hpp"

#include <gtest/gtest.h>

#include "core/scene/expected_speeds.hpp"
#include "core/terms/find_modules.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

/// A box of liquid between insulating walls along z, a hot plane at low x and a cold one at high x.
Scene cavity() {
  Scene s = emptyScene(0.1, {0, 0, 0}, {1, 0.6, 2});
  s.domain.gravity = {0, 0, -10};
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.side[2] = {Side::Wall, Side::Wall};
  s.materials.emplace_back();
  s.materials[0].expansion = 0.01;
  s.materials[0].expansionFrom = 300;
  s.materials[0].conductivity = {1, 1};
  addBox(s, {0, 0, 0}, {1, 0.6, 2}).temperature = 305;
  for (const double x : {0.0, 1.0}) {
    Obstacle& o = addFloor(s);
    o.shape.point = {x, 0, 0};
    o.shape.normal = {x > 0 ? -1.0 : 1.0, 0, 0};
    o.temperature = x > 0 ? 300 : 310;
  }
  return s;
}

}  // namespace

TEST(Buoyancy, TablesAreLinearAndConstantBeyondTheirEnds) {
  const TemperatureTable table{{273.15, 999.84}, {277.15, 999.97}, {283.15, 999.70}};
  EXPECT_EQ(valueAt(table, 200, Interpolation::Linear), 999.84);
  EXPECT_NEAR(valueAt(table, 275.15, Interpolation::Linear), 999.905, 1e-12);
  EXPECT_EQ(valueAt(table, 277.15, Interpolation::Linear), 999.97);
  EXPECT_EQ(valueAt(table, 400, Interpolation::Linear), 999.70);
}

TEST(Buoyancy, DeficitFollowsExpansionOrTable) {
  Domain d;
  Material m;
  m.expansion = 2e-4;
  EXPECT_NEAR(densityDeficit(d, m, d.ambient + 5), 1e-3, 1e-15);
  m.expansionFrom = 300;
  EXPECT_NEAR(densityDeficit(d, m, 290), -2e-3, 1e-15);
  m.densityTable = {{273.15, 999.84}, {277.15, 999.97}};
  m.density = 999.97;
  EXPECT_EQ(densityDeficit(d, m, 280), 0);
  EXPECT_NEAR(densityDeficit(d, m, 273.15), 0.13 / 999.97, 1e-12);
}

TEST(Buoyancy, RangeOfDeficitsContainsTheMaximumOfATable) {
  Scene s = cavity();
  s.materials[0].densityTable = {{300, 999}, {304, 1001}, {310, 997}};
  s.materials[0].density = 1000;
  const ValueRange range = deficitRange(s);
  EXPECT_NEAR(range.low, -1e-3, 1e-12);
  EXPECT_NEAR(range.high, 3e-3, 1e-12);
}

TEST(Buoyancy, SpeedFollowsFromTheRangeOfTemperaturesAndTheHeight) {
  Scene s = cavity();
  EXPECT_NEAR(buoyantSpeed(s), 0.5 * std::sqrt(10 * 0.1 * 2), 1e-12);
  s.domain.buoyantGravity = s.domain.gravity;
  s.domain.gravity = {};
  EXPECT_NEAR(buoyantSpeed(s), 0.5 * std::sqrt(10 * 0.1 * 2), 1e-12);
  EXPECT_NEAR(expectedFlow(s).speed, 0.5 * std::sqrt(10 * 0.1 * 2), 1e-12);
  EXPECT_NE(expectedFlow(s).why.find("buoyancy"), std::string::npos);
  s.materials[0].expansion = 0;
  EXPECT_EQ(buoyantSpeed(s), 0);
  EXPECT_EQ(expectedFlow(s).speed, 0);
}

TEST(Buoyancy, NeutralDeficitIsTheMiddleWhereTheHydrostaticPartIsSubtracted) {
  Scene s = cavity();
  EXPECT_EQ(neutralDeficit(s), 0);
  s.numerics.buoyancy = Buoyancy::Boussinesq;
  EXPECT_NEAR(neutralDeficit(s), 0.05, 1e-12);
}

TEST(Buoyancy, ClosedDomainsHaveWallsOrPlanesOnAllSides) {
  EXPECT_TRUE(liquidFillsClosedDomain(cavity()));
  Scene s = cavity();
  s.domain.side[2][1] = Side::Open;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.obstacles.pop_back();
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.obstacles[0].shape.point.x = 0.2;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.obstacles[0].shape.normal.x = -1;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.obstacles[0].until = 1;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
}

TEST(Buoyancy, ClosedDomainsAreFullOfLiquidOfOneDensity) {
  Scene s = cavity();
  s.bodies[0].shape.size.z = 1.9;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.bodies.clear();
  addBox(s, {0, 0, 0}, {1, 0.6, 0.5});
  addBox(s, {0, 0, 0.5}, {1, 0.6, 2});
  EXPECT_TRUE(liquidFillsClosedDomain(s));
  s.materials.push_back(s.materials[0]);
  s.bodies[1].material = 1;
  EXPECT_TRUE(liquidFillsClosedDomain(s));
  s.materials[1].density = 900;
  EXPECT_FALSE(liquidFillsClosedDomain(s));
  s = cavity();
  s.materials[0].young = {1e5, 0};
  EXPECT_FALSE(liquidFillsClosedDomain(s));
}

TEST(Buoyancy, ModuleNeedsExpansionGravityAndHeat) {
  EXPECT_TRUE(modulesOf(cavity()).buoyancy);
  Scene s = cavity();
  s.materials[0].expansion = 0;
  EXPECT_FALSE(modulesOf(s).buoyancy);
  s = cavity();
  s.domain.gravity = {};
  EXPECT_FALSE(modulesOf(s).buoyancy);
  s = cavity();
  s.obstacles.clear();
  EXPECT_FALSE(modulesOf(s).buoyancy);
}

TEST(Buoyancy, BodiesOfDifferentTemperaturesMakeHeatWithoutConduction) {
  Scene s = cavity();
  s.obstacles.clear();
  s.materials[0].conductivity = {0, 0};
  addBox(s, {0, 0, 0}, {1, 0.6, 0.5}).temperature = 320;
  const Modules m = modulesOf(s);
  EXPECT_TRUE(m.heat && m.buoyancy);
}

}  // namespace thaw::test
