// SPDX-License-Identifier: Apache-2.0
// Force fields of oriented bodies: region, time, and energy budget.
#include <gtest/gtest.h>

#include <cmath>

#include "core/oriented/forces/fields.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

constexpr OrientedIntegrator integrators[] = {
    OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta, OrientedIntegrator::SemiImplicit};

/// Particles that hardly interact.
Scene looseScene() {
  Scene s = test::emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "patch";
  b.source = OrientedSource::Patch;
  b.width = b.depth = 0.4;
  b.stiffness = 1e-9;
  b.damping = b.spinDamping = 0;
  b.velocity = {0, 0, 0.01};
  s.numerics.retryEvery = 0;
  s.numerics.maxStep = 1e-3;
  s.output.every = 0.1;
  return s;
}

TEST(OrientedFields, ActInTheirRegionForTheirTime) {
  for (const auto how : integrators) {
    Scene s = looseScene();
    s.oriented[0].integrator = how;
    OrientedField f;
    f.everywhere = false;
    f.region = test::boxOf({0.001, -1, -1}, {1, 1, 1});
    f.acceleration = {0, 2, 0};
    f.pressure = 3;
    f.from = 0.1;
    f.until = 0.3;
    s.oriented[0].fields = {f};
    f = {};
    f.acceleration = {0.5, 0, 0};
    f.inTime.points = {{0, 0}, {0.4, 1}};
    s.oriented[0].fields.push_back(f);
    s.end = 0.4;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const Oriented& o = x.w.oriented.rows;
    for (std::size_t i = 0; i < o.owned; i++) {
      const Vec3d moved = o.position[i] - Vec3d{0.5 * 0.4 * 0.4 / 6, 0, 0};
      if (std::abs(moved.x) < 0.02) continue;  // enters the region
      const bool in = moved.x > 0;
      EXPECT_NEAR(o.velocity[i].y, in ? 2 * 0.2 : 0, 0.005);
      EXPECT_NEAR(o.velocity[i].z, 0.01 + (in ? 3 * 0.2 : 0), 0.01);
      EXPECT_NEAR(o.velocity[i].x, 0.5 * 0.5 * 0.4, 0.001);
    }
    const LedgerReport ledgerReport = x.ledgerReport();
    EXPECT_LT(length(ledgerReport.momentumResidual), 1e-12);
    EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.01 * ledgerReport.energyScale)
        << static_cast<int>(how);
  }
}

/// Start and end of fields and corners of their factors lie within steps. The impulse is that of their whole
/// time.
TEST(OrientedFields, GiveTheSameImpulseForAnySteps) {
  for (const auto how : integrators)
    for (const double step : {1e-3, 0.0171, 0.09}) {
      Scene s = looseScene();
      OrientedBody& b = s.oriented[0];
      b.integrator = how;
      b.velocity = {};
      OrientedField f;
      f.acceleration = {0.05, 0, 0};
      f.from = 0.0333;
      f.until = 0.2777;
      b.fields = {f};
      f = {};
      f.acceleration = {0, 0.1, 0};
      f.inTime.points = {{0, 0}, {0.1, 1}, {0.17, 0}};
      b.fields.push_back(f);
      f = {};
      f.pressure = 0.03;
      f.from = 0.1;
      f.until = 0.11;
      f.inTime.points = {{0, 3}, {0.2, 1}};
      b.fields.push_back(f);
      s.numerics.maxStep = step;
      s.output.every = s.end = 0.4;
      test::Simulation x(s);
      ASSERT_TRUE(x.run());
      const Oriented& o = x.w.oriented.rows;
      const double perMass = orientedArea(x.w.scene.oriented[0], 0.05) / o.mass[0];
      Vec3d mean{};  // internal impulses cancel
      for (std::size_t i = 0; i < o.owned; i++) mean += o.velocity[i] / static_cast<double>(o.owned);
      EXPECT_NEAR(mean.x, 0.05 * (0.2777 - 0.0333), 1e-15) << step;
      EXPECT_NEAR(mean.y, 0.1 * 0.085, 1e-15) << step;
      // normals turn slightly
      EXPECT_NEAR(mean.z, 0.03 * 0.01 * (3 - 2 * 0.105 / 0.2) * perMass, 1e-10) << step;
      const LedgerReport ledgerReport = x.ledgerReport();
      EXPECT_LT(length(ledgerReport.momentumResidual), 1e-12);
      EXPECT_LT(std::abs(ledgerReport.energyResidual), 1e-7 * ledgerReport.energyScale)
          << static_cast<int>(how) << " " << step;
    }
}

TEST(OrientedFields, WithoutParticlesAtTheirStartAreReported) {
  Scene s = looseScene();
  OrientedField f;
  f.acceleration = {0, 0, 1};
  f.everywhere = false;
  f.region = test::boxOf({-1, -1, 0.5}, {1, 1, 1});
  s.oriented[0].fields = {f, f, f};
  s.oriented[0].fields[1].from = 0.05;
  s.oriented[0].fields[2].region = test::boxOf({-1, -1, -1}, {1, 1, 1});
  s.end = 0.1;
  test::Simulation x(s);
  ASSERT_EQ(x.tools.oriented.unusedFields.size(), 1u);
  ASSERT_TRUE(x.run());
  ASSERT_EQ(x.tools.oriented.unusedFields.size(), 2u);
  EXPECT_EQ(x.tools.oriented.unusedFields[1].field, 1u);
}

/// The force of a point derives from an energy. It acts inside its radius only, and a particle that passes
/// through keeps its speed.
TEST(OrientedFields, ForceOfAPointIsConservative) {
  for (const auto how : integrators)
    for (const double pull : {30.0, -30.0}) {
      Scene s = looseScene();
      OrientedBody& b = s.oriented[0];
      b.integrator = how;
      b.shape.move = {0, 0, -0.5};
      b.velocity = {0, 0, 4};
      OrientedField f;
      f.point = {0.03, 0.01, 0};
      f.attraction = pull;
      f.radius = 0.25;
      b.fields = {f};
      s.end = 0.25;
      s.numerics.maxStep = 2e-4;
      test::Simulation x(s);
      const double before = x.ledgerReport().now.kinetic;
      double most = 0, largest = 0;
      while (x.w.clock.time < s.end) {
        ASSERT_TRUE(x.step());
        const LedgerReport ledgerReport = x.ledgerReport();
        most = std::max(most, std::abs(ledgerReport.now.kinetic - before));
        largest = std::max(largest, std::abs(ledgerReport.energyResidual));
      }
      EXPECT_GT(most, 0.05 * before);
      EXPECT_LT(largest, 0.02 * most) << static_cast<int>(how);
      EXPECT_NEAR(x.ledgerReport().now.kinetic, before,
                  0.005 * most + (how == OrientedIntegrator::SemiImplicit ? 0.05 * most : 0))
          << static_cast<int>(how) << " " << pull;
    }
}

}  // namespace
}  // namespace thaw
