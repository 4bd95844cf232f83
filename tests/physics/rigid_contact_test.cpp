// SPDX-License-Identifier: Apache-2.0
// Rigid pieces in contact: exact solutions of sliding, rolling and impact, and stacks and piles at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/rigid/rig.hpp"

namespace thaw {
namespace {

constexpr double spacing = 0.1, slope = 0.5;

Vec3d along(double angle) { return {9.81 * std::sin(angle), 0, -9.81 * std::cos(angle)}; }

TEST(RigidContact, ABoxOnAnInclineHoldsOrSlides) {
  for (const double friction : {0.2, 0.5, 0.6}) {
    RigidRig rig(spacing, 6, 1e-3);
    rig.setFriction(friction, 0);
    rig.gravity = along(slope);
    rig.pieces.push_back(pieceOf(BoxDistance({0.5, 0.5, 0.5}), spacing, 1000));
    rig.pieces[0].centre = {-4, 0, 0.25};
    for (int n = 0; n < 500; n++) rig.step();
    const double exact = std::max(0.0, 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope)));
    EXPECT_NEAR(rig.pieces[0].velocity.x, exact, 0.02 * exact + 1e-6);
    EXPECT_NEAR(rig.pieces[0].centre.z, 0.25, 1e-3 * spacing);
  }
}

TEST(RigidContact, ABallRollsWithoutBumps) {
  for (const bool onSlab : {false, true}) {
    RigidRig rig(spacing, 6, 1e-3);
    rig.setFriction(0.5, 0);
    rig.gravity = along(0.01);
    if (onSlab) {  // practically immovable
      rig.pieces.push_back(pieceOf(BoxDistance({4, 1, 0.4}), spacing, 1000));
      rig.pieces[0].centre.z = 0.2;
      rig.pieces[0].mass = 1e20;
      rig.pieces[0].inertia = {1e20, 1e20, 1e20};
    }
    RigPiece ball = pieceOf(SphereDistance(0.3), spacing, 1000);
    const double ratio = ball.inertia.x / (ball.mass * 0.09), height = onSlab ? 0.7 : 0.3;
    ball.centre = {-1.03, 0.04, height};
    rig.pieces.push_back(ball);
    for (int n = 0; n < 1500; n++) {
      if (onSlab) rig.pieces[0].velocity = -rig.settings.step * rig.gravity;
      rig.step();
      EXPECT_NEAR(rig.pieces.back().centre.z, height, 2e-3 * spacing);
    }
    const double exact = 1.5 * rig.gravity.x / (1 + ratio);
    EXPECT_NEAR(rig.pieces.back().velocity.x, exact, 0.01 * exact);
  }
}

/// Rolls a body on a floor for some steps, in which it turns by 0.05 rad. Its centre may move up and down by
/// `bumps` (m).
RigPiece afterRolling(RigPiece body, double radius, double speed, int steps, double bumps) {
  RigidRig rig(spacing, 14, 0.05 * radius / speed);
  rig.setFriction(0.3, 0.5);
  body.centre = {-12, 0.04, radius};
  body.velocity = {speed, 0, 0};
  body.angularMomentum = {0, speed / radius / body.inverseInertia().yy, 0};
  rig.pieces.push_back(body);
  for (int n = 0; n < steps; n++) {
    rig.step();
    EXPECT_NEAR(rig.pieces[0].centre.z, radius, bumps);
  }
  return rig.pieces[0];
}

TEST(RigidContact, AFastBallRollsWithoutLoss) {
  const double radius = 0.6, speed = 6;
  const RigPiece ball = pieceOf(SphereDistance(radius), spacing, 1000),
                 end = afterRolling(ball, radius, speed, 700, 1e-3 * spacing);
  EXPECT_NEAR(end.velocity.x, speed, 1e-3 * speed);
  EXPECT_NEAR(end.centre.y, 0.04, 0.01 * spacing);
}

// The points of its rims close their gaps without impacts.
TEST(RigidContact, ACylinderRollsWithoutBumps) {
  const double radius = 0.5, speed = 5;
  RigPiece wheel = pieceOf(RevolvedDistance(cylinderOutline(radius, 0.8)), spacing, 1000);
  wheel.orientation = rotationBy({0.5 * std::numbers::pi, 0, 0});  // its axis is y
  const RigPiece end = afterRolling(wheel, radius, speed, 300, 0.01 * spacing);
  EXPECT_NEAR(end.velocity.x, speed, 0.01 * speed);
}

TEST(RigidContact, ABoxTopplesBeyondTheAngleOfItsEdge) {
  const double width = 0.4, height = 1.2, edge = std::atan(width / height);
  for (const double angle : {0.93 * edge, 1.05 * edge}) {
    RigidRig rig(spacing, 3, 2e-3);
    rig.setFriction(1, 0);
    rig.gravity = along(angle);
    rig.pieces.push_back(pieceOf(BoxDistance({width, width, height}), spacing, 1000));
    rig.pieces[0].centre = {0, 0, 0.5 * height};
    for (int n = 0; n < 1000; n++) rig.step();
    const bool stands = rig.pieces[0].centre.z > 0.99 * 0.5 * height;
    EXPECT_EQ(stands, angle < edge) << angle;
  }
}

/// Makes a piece practically immovable.
void holdPiece(RigPiece& p) {
  p.mass = 1e20;
  p.inertia = {1e20, 1e20, 1e20};
}

TEST(RigidContact, ABoxOnAPieceTopplesBeyondTheAngleOfItsEdge) {
  const double width = 0.4, height = 1.2, edge = std::atan(width / height);
  for (const double angle : {0.96 * edge, 1.04 * edge})
    for (const double turn : {0.0, 0.5}) {
      RigidRig rig(spacing, 3, 2e-3);
      rig.setFriction(1, 0);
      rig.gravity = along(angle);
      rig.pieces.push_back(pieceOf(BoxDistance({2, 2, 0.4}), spacing, 1000));
      rig.pieces[0].centre.z = 0.2;
      rig.pieces[0].orientation = rotationBy({0, 0, turn});
      holdPiece(rig.pieces[0]);
      rig.pieces.push_back(pieceOf(BoxDistance({width, width, height}), spacing, 1000));
      rig.pieces[1].centre = {0.03, 0.02, 0.4 + 0.5 * height};
      for (int n = 0; n < 800; n++) {
        rig.pieces[0].velocity = -rig.settings.step * rig.gravity;
        rig.step();
      }
      const bool stands = rig.pieces[1].centre.z > 0.4 + 0.99 * 0.5 * height;
      EXPECT_EQ(stands, angle < edge) << angle << " " << turn;
    }
}

TEST(RigidContact, ATowerStandsUpToItsLargestOverhang) {
  const int boxes = 4;
  const double width = 0.6, height = 0.3;
  for (const double part : {0.95, 1.05}) {
    RigidRig rig(spacing, 6, 2e-3);
    rig.setFriction(0.8, 0);
    double x = 0;
    for (int above = boxes - 1; above >= 0; above--) {
      rig.pieces.push_back(pieceOf(BoxDistance({width, width, height}), spacing, 1000));
      rig.pieces.back().centre = {x, 0, height * (boxes - above - 0.5)};
      if (above > 0) x += part * 0.5 * width / above;
    }
    for (int n = 0; n < 800; n++) rig.step();
    const bool stands = rig.pieces.back().centre.z > height * (boxes - 0.5) - 0.1 * spacing;
    EXPECT_EQ(stands, part < 1) << part;
  }
}

TEST(RigidContact, CrossedBarsTouchAtTheirEdges) {
  const double width = 0.4, across = 0.5 * width * std::sqrt(2.0);
  for (const double shift : {0.0, 0.02, 0.05, 0.13})
    for (const double angle : {0.2, 0.8, 1.5}) {
      RigidRig rig(spacing, 4, 1e-3);
      rig.setFriction(0.5, 0);
      rig.gravity = {0, 0, -1};
      for (int k = 0; k < 2; k++) {
        RigPiece bar = pieceOf(BoxDistance({2, width, width}), spacing, 1000);
        bar.orientation = rotationBy({0, 0, angle * k}) * rotationBy({0.25 * 3.14159265358979, 0, 0});
        bar.centre = {shift * k, 0.7 * shift * k, 1 + (2 * across + 0.02 * spacing) * k};
        rig.pieces.push_back(bar);
      }
      holdPiece(rig.pieces[0]);
      double lowest = 1;
      for (int n = 0; n < 100; n++) {
        rig.pieces[0].velocity = -rig.settings.step * rig.gravity;
        rig.step();
        lowest = std::min(lowest, rig.pieces[1].centre.z - 1 - 2 * across);
      }
      // a bar slides off slowly
      EXPECT_NEAR(lowest, 0, 0.02 * spacing) << shift << " " << angle;
    }
}

TEST(RigidContact, RollingFrictionSlowsOrHoldsABall) {
  const double radius = 0.3, angle = 0.05;
  for (const double arm : {0.3 * radius * std::tan(angle), 2 * radius * std::tan(angle)}) {
    RigidRig rig(spacing, 6, 1e-3);
    rig.setFriction(0.5, 0);
    rig.scene.materials[0].rollingFriction = arm;
    rig.gravity = along(angle);
    rig.pieces.push_back(pieceOf(SphereDistance(radius), spacing, 1000));
    rig.pieces[0].centre = {-1.03, 0.04, radius};
    const double ratio = rig.pieces[0].inertia.x / (rig.pieces[0].mass * radius * radius);
    for (int n = 0; n < 1000; n++) rig.step();
    const double exact = std::max(0.0, rig.gravity.x + arm / radius * rig.gravity.z) / (1 + ratio);
    EXPECT_NEAR(rig.pieces[0].velocity.x, exact, 0.01 * exact + 1e-6);
  }
}

TEST(RigidContact, RollingFrictionStopsASpin) {
  const double radius = 0.3, arm = 0.01, spin = 5;
  RigidRig rig(spacing, 3, 1e-3);
  rig.setFriction(0.5, 0);
  rig.scene.materials[0].rollingFriction = arm;
  rig.pieces.push_back(pieceOf(SphereDistance(radius), spacing, 1000));
  RigPiece& ball = rig.pieces[0];
  ball.centre = {0.01, 0.02, radius};
  ball.angularMomentum = ball.inertia.z * Vec3d{0, 0, spin};
  const double slowing = arm * ball.mass * 9.81 / ball.inertia.z, stops = spin / slowing;
  // The contact also takes the energy that gravity adds before it in each step.
  const double fall = rig.settings.step * 9.81, added = 0.5 * ball.mass * fall * fall;
  double energy = rig.kineticEnergy();
  for (double t = 0; t < 0.5 * stops; t += rig.settings.step) {
    rig.step();
    energy += added - rig.last.dissipated;
  }
  EXPECT_NEAR(ball.spin().z, 0.5 * spin, 0.01 * spin);
  EXPECT_NEAR(energy, rig.kineticEnergy(), 1e-3 * energy);
  for (double t = 0; t < 0.6 * stops; t += rig.settings.step) rig.step();
  EXPECT_LT(length(ball.spin()), 1e-3);
}

TEST(RigidContact, ReboundFollowsTheRestitution) {
  for (const bool box : {false, true})
    for (const double restitution : {0.3, 0.8}) {
      RigidRig rig(spacing, 3, 1e-3);
      rig.setFriction(0.5, restitution);
      rig.pieces.push_back(box ? pieceOf(BoxDistance({0.5, 0.5, 0.5}), spacing, 1000)
                               : pieceOf(SphereDistance(0.25), spacing, 1000));
      rig.pieces[0].centre = {0.01, 0.02, 1.25};
      double highest = 0;
      bool rising = false;
      for (int n = 0; n < 900; n++) {
        rig.step();
        rising = rising || rig.pieces[0].velocity.z > 0;
        if (rising) highest = std::max(highest, rig.pieces[0].centre.z - 0.25);
      }
      EXPECT_NEAR(std::sqrt(highest), restitution, 0.02 * restitution);
    }
}

/// A row of five balls. The first `moving` balls hit the others, which touch each other.
RigidRig cradle(int moving, double restitution) {
  RigidRig rig(spacing, 4, 1e-3);
  rig.gravity = {};
  rig.settings.impactSpeed = 0.02;
  rig.setFriction(0, restitution);
  for (int k = 0; k < 5; k++) {
    rig.pieces.push_back(pieceOf(SphereDistance(0.25), spacing, 1000));
    RigPiece& ball = rig.pieces.back();
    ball.centre = {0.5 * k - (k < moving ? 0.0505 : 0), 0, 1};
    if (k < moving) ball.velocity.x = 1;
  }
  return rig;
}

TEST(RigidContact, OnlyTheLastBallsOfACradleMoveOn) {
  for (const int moving : {1, 2, 3}) {
    RigidRig rig = cradle(moving, 1);
    const double energy = rig.kineticEnergy();
    for (int n = 0; n < 200; n++) {
      rig.step();
      EXPECT_LT(rig.kineticEnergy(), 1.0001 * energy);
    }
    for (int k = 0; k < 5; k++)
      EXPECT_NEAR(rig.pieces[static_cast<std::size_t>(k)].velocity.x, k >= 5 - moving, 1e-3) << moving;
  }
}

TEST(RigidContact, EachBallOfACradleLosesEnergyByItsRestitution) {
  // Impacts one after the other: the last ball has ((1 + e) / 2)^4 of the velocity.
  const double e = 0.9;
  RigidRig rig = cradle(1, e);
  for (int n = 0; n < 100; n++) rig.step();
  double momentum = 0;
  for (const RigPiece& p : rig.pieces) momentum += p.velocity.x;
  EXPECT_NEAR(momentum, 1, 1e-6);
  EXPECT_NEAR(rig.pieces.back().velocity.x, std::pow(0.5 * (1 + e), 4), 0.005);
}

TEST(RigidContact, AStackOfTenBoxesRests) {
  RigidRig rig(spacing, 6, 2e-3);
  rig.setFriction(0.5, 0);
  for (int i = 0; i < 10; i++) {
    rig.pieces.push_back(pieceOf(BoxDistance({0.5, 0.5, 0.5}), spacing, 1000));
    rig.pieces[static_cast<std::size_t>(i)].centre = {0.01 * (i % 3), 0.01 * (i % 2), 0.25 + 0.5 * i};
    rig.pieces[static_cast<std::size_t>(i)].orientation = rotationBy({0, 0, 0.1 * i});
  }
  const std::vector<RigPiece> start = rig.pieces;
  for (int n = 0; n < 1000; n++) rig.step();
  for (std::size_t i = 0; i < start.size(); i++)
    EXPECT_LT(length(rig.pieces[i].centre - start[i].centre), 0.02 * spacing);
  EXPECT_LT(rig.iterations, 1000 * 150);
}

TEST(RigidContact, TheEnergyOfAPileOnlyFalls) {
  RigidRig rig(spacing, 6, 1e-3);
  for (const double side : {-1.0, 1.0}) {
    rig.addWall({0.8 * side, 0, 0}, {-side, 0, 0});
    rig.addWall({0, 0.8 * side, 0}, {0, -side, 0});
  }
  rig.setFriction(0.4, 0.2);
  rig.scene.materials[0].rollingFriction = 0.01;
  for (int i = 0; i < 16; i++) {
    RigPiece p = i % 2 ? pieceOf(BoxDistance({0.6, 0.4, 0.5}), spacing, 1000)
                       : pieceOf(SphereDistance(0.3), spacing, 1000);
    p.centre = {i & 1 ? -0.37 : 0.37, i & 2 ? -0.37 : 0.37, 0.5 + 0.9 * (i / 4)};
    p.orientation = rotationBy({0.3 * i, 0.7 * i, 0.1 * i});
    rig.pieces.push_back(p);
  }
  double lowest = rig.energy(), deepest = 0;
  for (int n = 0; n < 1500; n++) {
    rig.step();
    const double energy = rig.energy() - rig.lifted;
    EXPECT_LT(energy - lowest, 1e-6 * lowest);
    lowest = std::min(lowest, energy);
    deepest = std::max(deepest, rig.last.deepest);
  }
  EXPECT_LT(rig.lifted, 3e-3 * lowest);
  EXPECT_LT(deepest, 0.1 * spacing);
  EXPECT_LT(rig.kineticEnergy(), 0.02 * lowest);
}

}  // namespace
}  // namespace thaw
