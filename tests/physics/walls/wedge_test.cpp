// SPDX-License-Identifier: Apache-2.0
// Liquid that flows into a wedge between a floor and a slope.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/walls/wall_forces.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

struct Wedge {
  double angle;      ///< degrees
  double viscosity;  ///< Pa s
  double height;     ///< m
  double speed;      ///< m/s, along x
};

/// A coarse slab of liquid in front of a wedge, periodic along the wedge's edge, the y axis.
Scene liquidInto(const Wedge& wedge) {
  constexpr double spacing = 0.06, width = 6 * spacing, length = 0.6;
  const double angle = wedge.angle * std::numbers::pi / 180;
  Scene s = emptyScene(spacing, {-2, 0, -0.5}, {3, width, 3.5});
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.gravity = {0, 0, -9.81};
  carryDensity(s, 0.07);
  s.materials.emplace_back();
  s.materials[0].density = 2700;
  s.materials[0].viscosity = {wedge.viscosity, wedge.viscosity};
  const double start = std::max(0.35, wedge.height / std::tan(angle) + 0.1);
  addBox(s, {start, 0, 0}, {start + length, width, wedge.height}).velocity = {wedge.speed, 0, 0};
  addFloor(s);
  addFloor(s).shape.rotate = {0, std::numbers::pi - angle, 0};
  s.numerics.cflSound = 0.2;
  s.end = 0.2;
  return s;
}

}  // namespace

// If shifting pushed particles at one wall into the other, their contact springs would gain energy.
TEST(LiquidInAWedge, GainsNoEnergy) {
  constexpr double water = 1e-3, lava = 60;
  for (const Wedge& wedge : {Wedge{30, water, 0.3, -3}, Wedge{45, water, 0.3, -3}, Wedge{60, water, 0.24, -2},
                             Wedge{45, lava, 0.3, -2}}) {
    SCOPED_TRACE(testing::Message() << wedge.angle << " degrees, " << wedge.viscosity << " Pa s");
    Simulation r(liquidInto(wedge));
    ASSERT_TRUE(r.run());
    const LedgerReport report = r.ledgerReport();
    EXPECT_LT(std::abs(report.energyResidual), 0.01 * report.energyScale);
  }
}

TEST(LiquidInAWedge, HasNeitherShiftingNorCorrectedGradientsAcrossWalls) {
  for (const double angle : {30.0, 60.0, 120.0}) {
    SCOPED_TRACE(angle);
    Simulation r(liquidInto({angle, 1, 0.24, -3}));
    const Continuum& p = r.particles();
    double shifted = 0, correction = 0;
    std::size_t between = 0;
    while (r.w.clock.time < r.w.clock.end) {
      ASSERT_TRUE(r.step());
      for (const WallContact& c : r.tools.walls.contacts.list) {
        const std::span<const WallContact> all = contactsOf(r.tools.walls.contacts, c.row);
        between += all.size() > 1;
        const auto noneNearer = [&](double than) {
          return std::ranges::none_of(all, [&](const WallContact& o) { return o.distance < than; });
        };
        const auto allNearer = [&](double than) {
          return std::ranges::all_of(all, [&](const WallContact& o) { return o.distance < than; });
        };
        const Vec3d byNormal = wide(p.midCorrection[c.row]) * c.normal;
        if (noneNearer(c.distance)) correction = std::max(correction, std::abs(dot(c.normal, byNormal)));
        if (all.size() > 1 && allNearer(0.5 * r.w.grid.support))
          correction = std::max(correction, length(byNormal));
        if (c.distance < r.w.scene.spacing)
          shifted = std::max(shifted, std::abs(dot(p.shiftingVelocity[c.row], c.normal)));
      }
    }
    EXPECT_GT(between, 1000u);
    EXPECT_LT(shifted, 1e-9);
    EXPECT_LT(correction, 1e-4);
  }
}

}  // namespace thaw::test
