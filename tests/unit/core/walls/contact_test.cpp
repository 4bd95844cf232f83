// SPDX-License-Identifier: Apache-2.0
// Contact of particles with walls: springs, dashpots, friction, projection, motion, and energy budget.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/wall_rig.hpp"

namespace thaw::test {
namespace {

constexpr double dt = 1e-3;  // the contact limit is 5e-3

/// Ground whose normal is inclined in the x-z plane.
struct Slope : SignedDistance {
  Vec3d n;
  explicit Slope(double angle) : n{std::sin(angle), 0, std::cos(angle)} {}
  double distance(const Vec3d& x, Vec3d* g) const override {
    if (g) *g = n;
    return dot(n, x);
  }
  Bounds bounds() const override { return {{-never, -never, -never}, {never, never, never}}; }
};

/// Height of the first bounce.
double bounceHeight(WallRig& r, double step) {
  double highest = -1;
  bool down = true;
  for (int k = 0; k < 14000; k++) {
    r.step(step);
    if (r.w.particles.velocity[0].z > 0) down = false;
    if (!down) highest = std::max(highest, r.w.particles.position[0].z);
    if (!down && r.w.particles.velocity[0].z < 0) break;
  }
  return highest;
}

}  // namespace

// The density rate uses contacts at the start of the step too, whose shares differ where walls overlap.
TEST(WallContact, SharesFollowFromDistances) {
  WallRig r;
  r.add(std::make_shared<Slope>(0.0)), r.add(std::make_shared<Slope>(1.5));
  const Vec3d v{-3, 0.5, -2}, x{0.12, 0.02, 0.09};
  r.addParticle(x, v, Liquid);
  r.start();
  const std::vector<WallContact> earlier = r.contacts.list;
  ASSERT_EQ(earlier.size(), 2U);
  const double ago = 0.01;
  r.w.particles.position[0] = x + v * ago;
  r.evaluate(0);
  std::vector<WallContact> moved = r.contacts.list;
  ASSERT_EQ(moved.size(), 2U);
  for (WallContact& c : moved) c.distance -= ago * dot(v, c.normal);
  for (std::size_t k = 0; k < 2; k++) {
    EXPECT_NEAR(moved[k].distance, earlier[k].distance, 1e-12);
    EXPECT_NEAR(pressureShare({r.tables, r.w.grid.support}, moved, k), earlier[k].share, 1e-12);
    EXPECT_GT(std::abs(moved[k].share - earlier[k].share), 0.005);
  }
}

TEST(WallContact, PerfectRestitutionKeepsEnergyOverManyBounces) {
  WallRig r;
  r.add(std::make_shared<Ground>());
  r.addParticle({0.03, 0, 0.2}, {0, 0, 0});
  r.start();
  const double e = r.mechanical(), scale = r.w.particles.mass[0] * 9.81 * 0.15;
  double worst = 0;
  for (int k = 0; k < 5000; k++) {
    r.step(dt);
    worst = std::max(worst, std::abs(r.mechanical() - e));
  }
  EXPECT_LT(worst, 0.02 * scale);  // the leap-frog energy oscillates without drift
  EXPECT_LT(std::abs(r.mechanical() - e), 0.02 * scale);
  EXPECT_EQ(r.dissipated(), 0);
}

TEST(WallContact, BouncesWithItsRestitution) {
  for (double e : {0.9, 0.5, 0.3}) {
    WallRig r;
    r.w.scene.materials[0].young = {1e6, 1e6};  // stiff: gravity is negligible during contact
    r.add(std::make_shared<Ground>()).restitution = e;
    r.addParticle({0, 0, 0.55}, {0, 0, 0});
    r.start();
    const double start = r.mechanical(), rest = 0.05;  // centres rest half a spacing above the wall
    // at the same fraction of the contact limit
    EXPECT_NEAR(std::sqrt((bounceHeight(r, 0.3 * dt) - rest) / 0.5), e, 0.06) << e;
    EXPECT_NEAR(r.mechanical() + r.dissipated(), start, 0.01 * std::abs(start));
  }
}

TEST(WallContact, ImpulseIsTheChangeOfMomentumToRounding) {
  WallRig r;
  Obstacle& o = r.add(std::make_shared<Slope>(0.3));
  o.restitution = 0.4;
  r.addParticle({0.1, 0, 0.3}, {1, 0.5, -2});
  r.addParticle({0.4, 0.2, 0.2}, {-1, 0.5, 0});
  r.start();
  const auto momentum = [&] {
    Vec3d s{};
    for (std::size_t i = 0; i < 2; i++) s += r.w.particles.mass[i] * r.w.particles.velocity[i];
    return s;
  };
  const Vec3d before = momentum();
  double time = 0;
  for (int k = 0; k < 700; k++) {
    const double step = k % 3 ? dt : 0.6 * dt;
    r.step(step);
    time += step;
  }
  Vec3d given = r.w.scene.domain.gravity * (2 * r.w.particles.mass[0] * time);
  for (int a = 0; a < 3; a++) given[a] += r.w.ledger.wallImpulse[a].value();
  EXPECT_GT(r.w.ledger.wallImpulse[2].value(), 0.1);
  EXPECT_LT(length(momentum() - before - given), 1e-12 * length(given));
}

TEST(WallContact, FrictionHoldsUpToItsAngle) {
  const double angle = 0.4;  // tan = 0.423
  for (double mu : {0.0, 0.2, 0.7}) {
    WallRig r;
    Obstacle& o = r.add(std::make_shared<Slope>(angle));
    o.friction = mu;
    o.restitution = 0.2;
    const Vec3d n{std::sin(angle), 0, std::cos(angle)}, down{std::cos(angle), 0, -std::sin(angle)};
    const double g = 9.81, m = 1, sink = m * g * std::cos(angle) / (1e5 * 0.1);  // at rest on the spring
    r.addParticle(n * (0.05 - sink), {});
    r.start();
    for (int k = 0; k < 300; k++) r.step(dt);
    const double speed = dot(r.w.particles.velocity[0], down),
                 free = g * (std::sin(angle) - mu * std::cos(angle)) * 0.3;
    if (free > 0) {
      EXPECT_NEAR(speed, free, 0.02 * free) << mu;
    } else {
      EXPECT_GE(speed, 0);  // friction never reverses the motion
      // the rest is the creep of the regularised law
      EXPECT_LT(speed, 1.1 * m * g * std::sin(angle) / std::sqrt(1e5 * 0.1 * m));
    }
  }
}

// The friction spring lets it swing back, by at most its displacement at the limit of friction.
TEST(WallContact, FrictionStopsASlider) {
  WallRig r;
  Obstacle& o = r.add(std::make_shared<Ground>());
  o.friction = 0.5;
  o.restitution = 0.2;
  r.addParticle({0, 0, 0.05 - 9.81 / 1e4}, {1, 0.2, 0});
  r.start();
  const double energy = r.mechanical();
  double before = r.w.particles.velocity[0].x;
  bool slides = true;
  const double back = 0.5 * 9.81 / std::sqrt(1e4);  // m/s, by a spring of 1e4 N/m on 1 kg
  for (int k = 0; k < 1000; k++) {
    r.step(dt);
    const double v = r.w.particles.velocity[0].x;
    slides = slides && v > 0;
    EXPECT_GE(v, slides ? 0 : -back);
    EXPECT_LE(v, slides ? before + 1e-12 : back);
    before = v;
  }
  EXPECT_LT(std::abs(before), 1e-9);
  const double v2 = 1.04;
  EXPECT_NEAR(r.w.particles.position[0].x, std::sqrt(1 / v2) * v2 / (2 * 0.5 * 9.81), 0.005);
  EXPECT_NEAR(r.dissipated(), 0.5 * v2, 0.001);
  EXPECT_NEAR(r.mechanical() + r.dissipated(), energy, 1e-4);
}

TEST(WallContact, DeepParticlesAreProjectedOutAndRecorded) {
  WallRig r;
  Obstacle& o = r.add(std::make_shared<Ground>());
  o.motion = {{0, {0, 0, 0}, {}}, {1, {0.1, 0, 0.2}, {}}};
  r.addParticle({0, 0, -0.3}, {1, 0, -3});
  moveWalls(r.w.walls, 0.5);  // surface at z = 0.1, rising with 0.2 m/s
  r.start();
  const Continuum& p = r.w.particles;
  EXPECT_NEAR(p.position[0].z, 0.05, 1e-15);  // half a spacing deep
  EXPECT_NEAR(p.velocity[0].z, 0.2, 1e-15);
  EXPECT_EQ(p.velocity[0].x, 1);
  EXPECT_EQ(r.w.counters.wallProjections, 1);
  EXPECT_NEAR(r.w.ledger.wallImpulse[2].value(), 3.2, 1e-14);
  // energy: before + work of the wall = after + dissipated, with the spring of the contact (1e4 N/m)
  const double before = 0.5 * (1 + 9) + 9.81 * -0.3 + 0.5 * 1e4 * 0.45 * 0.45;
  EXPECT_NEAR(before + r.w.ledger.wallWork.value(), r.mechanical() + p.dissipated[0], 1e-10);
}

TEST(WallContact, MovingWallsCarryAndDoWork) {
  WallRig r;
  Obstacle& o = r.add(std::make_shared<Ground>());
  o.motion = {{0, {}, {}}, {1, {0.5, 0, 0.3}, {}}};
  o.friction = 1;
  o.restitution = 0.2;
  r.addParticle({0, 0, 0.049}, {});
  r.start();
  const double before = r.mechanical();
  for (int k = 0; k < 800; k++) r.step(dt);
  EXPECT_NEAR(r.w.particles.velocity[0].x, 0.5, 1e-6);
  EXPECT_NEAR(r.w.particles.velocity[0].z, 0.3, 0.02);
  EXPECT_NEAR(r.mechanical() - before, r.w.ledger.wallWork.value() - r.dissipated(), 0.01);
  EXPECT_GT(r.w.ledger.wallWork.value(), 9.81 * 0.2);
}

TEST(WallContact, RotatingWallHasItsVelocityField) {
  WallRig r;
  Obstacle& o = r.add(std::make_shared<Ground>());
  o.motion = {{0, {}, {}}, {1, {0, 0, 0.1}, {0.2, 0.3, 1.0}}};
  r.start();
  // the velocity of a point is the derivative of its position
  const Vec3d x{0.3, -0.2, 0.1};
  const auto place = [&](double t) {
    moveWalls(r.w.walls, t);
    return fromRest(r.w.walls.list[0].pose, x);
  };
  const Vec3d a = place(0.5 - 1e-5), b = place(0.5 + 1e-5), at = place(0.5);
  EXPECT_LT(length((b - a) / 2e-5 - wallVelocity(r.w.walls.list[0], at)), 1e-8);
  moveWalls(r.w.walls, 2);  // after the last keyframe it rests
  EXPECT_EQ(length(wallVelocity(r.w.walls.list[0], at)), 0);
}

TEST(WallContact, ObstaclesDisappear) {
  WallRig r;
  r.add(std::make_shared<Ground>()).until = 0.5;
  r.addParticle({0, 0, 0.01}, {});
  r.start();
  EXPECT_EQ(r.contacts.list.size(), 1u);
  moveWalls(r.w.walls, 0.5);
  r.evaluate(dt);
  EXPECT_TRUE(r.contacts.list.empty());
}

TEST(WallContact, ContactsEqualBruteForce) {
  WallRig r;
  r.w.scene.domain.side = {{{Side::Wall, Side::Wall}, {Side::Wall, Side::Open}, {Side::Open, Side::Open}}};
  addDomainWalls(r.w.scene.domain, r.w.walls);
  r.add(std::make_shared<Slope>(0.7));
  for (int k = 0; k < 4000; k++) {
    const double a = std::fmod(k * 0.754877666, 1.0), b = std::fmod(k * 0.569840296, 1.0),
                 c = std::fmod(k * 0.362, 1.0);
    r.addParticle({4.1 * a - 2.05, 4.1 * b - 2.05, 4 * c - 2}, {});
  }
  r.w.scene.spacing = 0.1;
  r.start();
  r.evaluate(0);
  std::size_t at = 0;
  for (std::size_t i = 0; i < r.w.particles.owned; i++)
    for (std::size_t k = 0; k < r.w.walls.list.size(); k++) {
      Vec3d n;
      const double d = r.w.walls.list[k].shape->distance(r.w.particles.position[i], &n);
      if (d >= r.w.grid.support) continue;
      ASSERT_LT(at, r.contacts.list.size());
      EXPECT_EQ(r.contacts.list[at].row, i);
      EXPECT_EQ(r.contacts.list[at].wall, k);
      EXPECT_NEAR(r.contacts.list[at].distance, d, 1e-15);
      at++;
    }
  EXPECT_EQ(at, r.contacts.list.size());
}

}  // namespace thaw::test
