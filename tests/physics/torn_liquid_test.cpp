// SPDX-License-Identifier: Apache-2.0
// Liquids that are torn gain no energy.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

struct Tear {
  double spacing, viscosity, tension;
  Vec3d size, velocity;  ///< m, m/s: of one half; the other half has the opposite velocity
  double end;
  double gap = 0;  ///< m, between the halves at the start
};

/// Two halves of a weightless block of liquid, which move apart.
Scene torn(const Tear& t) {
  const double far = 20 * t.size.z;
  Scene s = test::emptyScene(t.spacing, {-far, -far, -far}, {far, far, far});
  test::carryDensity(s, t.tension > 0 ? 0.02 : 0.2);
  s.materials.emplace_back();
  s.materials[0].density = 1500;
  s.materials[0].viscosity = {t.viscosity, t.viscosity};
  s.materials[0].surfaceTension = t.tension;
  for (const double side : {-1.0, 1.0}) {
    const Vec3d low = {side < 0 ? -t.size.x - 0.5 * t.gap : 0.5 * t.gap, -0.5 * t.size.y, -0.5 * t.size.z};
    test::addBox(s, low, low + t.size).velocity = t.velocity * side;
  }
  s.end = t.end;
  return s;
}

/// Returns the unexplained energy relative to the initial kinetic energy.
double unexplained(const Scene& s) {
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic;
  EXPECT_TRUE(r.run());
  return r.ledgerReport().energyResidual / kinetic;
}

// Without the limit on the density change of a step, detached particles oscillate from step to step. The
// energy then grows by more than 10 %.
TEST(TornLiquid, GainsNoEnergy) {
  const Tear coarse{0.156553, 10.7, 0, {0.344, 1.224, 1.172}, {1.843, 0.346, 0}, 2.5};
  EXPECT_LT(std::abs(unexplained(torn(coarse))), 0.03);
}

// Shifting moves particles against the tension as well.
TEST(TornLiquid, WorkOfShiftingAgainstTensionIsRecorded) {
  const Tear drops{0.0075, 0.5, 0.088, {0.0225, 0.06, 0.0675}, {0.222, 0.0264, 0}, 0.8, 0.0025};
  EXPECT_LT(std::abs(unexplained(torn(drops))), 0.01);
}

// A falling jet stretches, and particles accumulate at its axis. With corrected gradients at its surface they
// oscillate, and the energy grows.
TEST(TornLiquid, ThinJetGainsNoEnergy) {
  Scene s = test::emptyScene(4e-3, {-0.08, -0.08, -0.01}, {0.08, 0.08, 0.22});
  s.domain.gravity = {0, 0, -9.81};
  test::carryDensity(s, 0.2);
  s.materials.emplace_back();
  s.materials[0].density = 1300;
  s.materials[0].viscosity = {1, 1};
  test::addFloor(s);
  Emitter& jet = s.emitters.emplace_back();
  jet.radius = 9e-3;
  jet.centre = {0, 0, 0.18};
  jet.speed = 0.5;
  s.end = 0.18;
  Simulation r(s);
  EXPECT_TRUE(r.run());
  const LedgerReport report = r.ledgerReport();
  EXPECT_LT(std::abs(report.energyResidual), 0.01 * report.energyScale);
}

}  // namespace
}  // namespace thaw
