// SPDX-License-Identifier: Apache-2.0
// The contact of an oriented surface stores more energy than the kinetic energy of a particle before the
// particle is through. This holds for any masses and spacings.
#include <gtest/gtest.h>

#include <cmath>

#include "core/oriented/laws/plan_contact.hpp"

namespace thaw {
namespace {

Scene sceneOf(double ownSpacing, double young, double stiffness) {
  Scene s;
  s.spacing = 0.01;
  s.domain.gravity = {0, 0, -9.81};
  s.domain.min = {0, 0, 0};
  s.domain.max = {1, 1, 0.5};
  s.materials.emplace_back();
  s.materials[0].young = {young, young};
  s.bodies.emplace_back();
  s.bodies[0].velocity = {0, 0, -2};
  s.oriented.emplace_back();
  s.oriented[0].spacing = ownSpacing;
  s.oriented[0].stiffness = stiffness;
  return s;
}

TEST(OrientedContactPlan, HoldsAParticleAtTheSpeedOfTheScene) {
  for (const double spacing : {0.005, 0.01, 0.03})
    for (const double young : {1e4, 1e7})
      for (const double density : {0.1, 1.0, 100.0}) {
        Scene s = sceneOf(spacing, young, 10);
        s.oriented[0].density = density;
        const OrientedContact c = planOrientedContact(s, liquidMaterials(s))[0];
        const double mass = 1000 * std::pow(s.spacing, 3), v = 2 + std::sqrt(2 * 9.81 * 0.5);
        const Touch t = touchOf(contactLaw(c, 0, mass, 1e-5), c.room, {0, 0, 1}, {});
        EXPECT_GT(t.energy, 4 * 0.5 * mass * v * v * (1 - 1e-9)) << spacing << ' ' << young << ' ' << density;
        EXPECT_LT(c.room, c.reach);
      }
}

TEST(OrientedContactPlan, FollowsTheBonds) {
  const Scene soft = sceneOf(0.01, 1e4, 10), stiff = sceneOf(0.01, 1e4, 1e6);
  const double a = planOrientedContact(soft, liquidMaterials(soft))[0].bonds,
               b = planOrientedContact(stiff, liquidMaterials(stiff))[0].bonds;
  EXPECT_NEAR(b / a, 1e5, 1);
}

// The stiffness that limits the step is that of the force, and is known before contact begins.
TEST(OrientedContactPlan, IncludesApproachingContact) {
  const Scene s = sceneOf(0.01, 1e5, 10);
  const OrientedContact c = planOrientedContact(s, liquidMaterials(s))[0];
  TouchLaw law = contactLaw(c, 0, 1e-3, 1e-4);
  law.restitution = 1;  // the dashpot adds no stiffness
  const double depth = 0.5 * c.room, d = 1e-8;
  const double difference = (touchOf(law, depth + d, {0, 0, 1}, {}).force.z -
                             touchOf(law, depth - d, {0, 0, 1}, {}).force.z) /
                            (2 * d);
  EXPECT_NEAR(touchOf(law, depth, {0, 0, 1}, {}).slope, difference, 1e-6 * difference);
  EXPECT_EQ(slopeAhead(law, -1e-3, -1), 0);  // a tenth of a millimetre per step
  EXPECT_GT(slopeAhead(law, -1e-3, -20), 0);
  EXPECT_EQ(slopeAhead(law, -1e-3, 20), 0);  // it separates
}

// Toward obstacles: force and stiffness are the derivatives of one energy. At full depth the force exceeds
// the strength of bonds. The stored energy exceeds the kinetic energy of a particle.
TEST(OrientedContactPlan, KeepsASurfaceOffObstacles) {
  for (const double density : {0.1, 100.0}) {
    Scene s = sceneOf(0.01, 1e5, 10);
    s.oriented[0].density = density;
    const ObstacleContact c = planObstacleContact(s)[0];
    EXPECT_EQ(c.keep, 0.005);
    for (const double depth : {0.2 * c.room, 0.7 * c.room, 1.5 * c.room}) {
      const double d = 1e-6 * c.room,
                   force = (obstacleForceAt(c, depth + d).energy - obstacleForceAt(c, depth - d).energy) /
                           (2 * d);
      EXPECT_NEAR(obstacleForceAt(c, depth).force, force, 1e-6 * force);
      EXPECT_NEAR(obstacleForceAt(c, depth).slope + c.spring,
                  (obstacleForceAt(c, depth + d).force - obstacleForceAt(c, depth - d).force) / (2 * d),
                  1e-5 * (obstacleForceAt(c, depth).slope + c.spring));
    }
    const double v = std::sqrt(2 * 9.81 * 0.5);
    EXPECT_GT(obstacleForceAt(c, c.room).energy,
              4 * 0.5 * orientedMass(s.oriented[0], 0.01) * v * v * (1 - 1e-9));
    EXPECT_GT(obstacleForceAt(c, c.room).force,
              8 * s.oriented[0].attract * s.oriented[0].stiffness * 0.01 * (1 - 1e-9));
  }
}

}  // namespace
}  // namespace thaw
