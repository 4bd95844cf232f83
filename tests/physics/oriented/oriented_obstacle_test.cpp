// SPDX-License-Identifier: Apache-2.0
// With the default contact, solids do not pass through oriented surfaces, and vice versa.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/simulation/monitor/interpenetration.hpp"
#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

Body& addElastic(Scene& s, double young, const Vec3d& low, const Vec3d& high) {
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].density = 1000;
  s.materials[0].young = {young, young};
  return test::addBox(s, low, high);
}

std::int64_t interpenetrating(test::Simulation& x) {
  std::int64_t n = 0;
  for (const Interpenetration& s : findInterpenetrations(x.w, x.halos())) n += s.count;
  return n;
}

/// A block of 4 cm falls at 2 m/s on a surface that is fixed at its edge, or (fixed) everywhere.
Scene blockOnFilm(bool fixed) {
  Scene s = test::emptyScene(0.01, {-0.25, -0.25, -0.3}, {0.25, 0.25, 0.3});
  s.domain.gravity = {0, 0, -9.81};
  addElastic(s, 1e5, {-0.017, -0.018, 0.02}, {0.023, 0.022, 0.06}).velocity = {0, 0, -2};
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "film";
  b.source = OrientedSource::Patch;
  b.width = b.depth = fixed ? 0.12 : 0.24;
  OrientedConstraint edge;
  edge.region = test::boxOf({-0.5, -0.5, -0.1}, {0.5, 0.5, 0.1});
  if (!fixed) {
    Shape middle = test::boxOf({-0.11, -0.11, -0.2}, {0.11, 0.11, 0.2}), whole = edge.region;
    edge.region = Shape{};
    edge.region.kind = ShapeKind::Difference;
    edge.region.parts = {whole, middle};
  }
  b.constraints.push_back(edge);
  s.end = 0.06;
  return s;
}

struct Outcome {
  std::int64_t most = 0;
  double bodyLow = 0, bodySpeed = 0, filmLow = 0, residual = 0, momentum = 0;
  std::int64_t steps = 0;
};

Outcome runBlock(const Scene& s) {
  test::Simulation x(s);
  Outcome out;
  double worst = 0;
  while (x.w.clock.time < x.w.clock.end) {
    EXPECT_TRUE(x.step());
    if (x.w.clock.step % 20 == 0)
      out.most = std::max(out.most, interpenetrating(x)),
      worst = std::max(worst, std::abs(x.ledgerReport().energyResidual));
  }
  const Continuum& p = x.w.particles;
  out.bodyLow = 1, out.filmLow = 1;
  for (std::size_t i = 0; i < p.owned; i++)
    out.bodyLow = std::min(out.bodyLow, p.position[i].z),
    out.bodySpeed += p.velocity[i].z / static_cast<double>(p.owned);
  for (std::size_t i = 0; i < x.w.oriented.rows.owned; i++)
    out.filmLow = std::min(out.filmLow, x.w.oriented.rows.position[i].z);
  const LedgerReport l = x.ledgerReport();
  out.residual = worst / l.energyScale;
  out.momentum = length(l.momentumResidual) / length(l.initial.momentum + l.gravityImpulse);
  out.steps = x.w.clock.step;
  std::printf(
      "most inside %lld, lowest of the body %.4f, mean speed %.3f, lowest of the film %.4f m; residual %.2e "
      "of the scale, momentum %.1e; %lld steps\n",
      static_cast<long long>(out.most), out.bodyLow, out.bodySpeed, out.filmLow, out.residual, out.momentum,
      static_cast<long long>(out.steps));
  return out;
}

TEST(OrientedObstacle, BlockDoesNotSinkThroughAFixedSurface) {
  const Outcome o = runBlock(blockOnFilm(true));
  EXPECT_EQ(o.most, 0);
  EXPECT_GT(o.bodyLow, 0.003);
  EXPECT_GT(o.bodySpeed, 0);  // it has bounced
}

TEST(OrientedObstacle, BlockDragsASurfaceFixedAtItsEdge) {
  const Outcome o = runBlock(blockOnFilm(false));
  EXPECT_EQ(o.most, 0);
}

TEST(OrientedObstacle, BlanketStaysOutOfTheBodyBelow) {
  Scene s = test::emptyScene(0.01, {-0.25, -0.25, -0.05}, {0.25, 0.25, 0.3});
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  addElastic(s, 2e4, {-0.04, -0.04, 0}, {0.04, 0.04, 0.08});
  s.materials[0].damping = 5;
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "blanket";
  b.source = OrientedSource::Disc;
  b.radius = 0.107;
  b.density = 20;  // as heavy as the block
  b.shape.move = {0.003, 0.002, 0.12};
  b.velocity = {0, 0, -1.5};
  s.end = 0.12;
  const Outcome o = runBlock(s);
  EXPECT_EQ(o.most, 0);
}

/// A film that grows where it is stretched falls on a ball. New particles within contact distance of the
/// ball's particles must not be ejected by the barrier.
TEST(OrientedObstacle, BirthsInContactAreNotEjected) {
  Scene s = test::emptyScene(0.02, {-0.3, -0.3, -0.02}, {0.3, 0.3, 0.3});
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  s.materials.emplace_back();
  s.materials[0].name = "wax";
  s.materials[0].density = 900;
  s.materials[0].young = {1.5e5, 1.5e5};
  s.materials[0].law.name = "neo-hookean";
  s.materials[0].damping = 4;
  Body& ball = test::addBox(s, {}, {});
  ball.shape = Shape{};
  ball.shape.kind = ShapeKind::Sphere;
  ball.shape.radius = 0.07;
  ball.shape.move = {0, 0, 0.074};
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "film";
  b.source = OrientedSource::Disc;
  b.radius = 0.19;
  b.shape.move = {0, 0, 0.18};
  b.velocity = {0, 0, -1.5};
  b.density = 1;
  b.stiffness = 2;
  b.contact = 4;
  b.integrator = OrientedIntegrator::SymplecticEuler;
  b.pressure = -10;
  b.growth = OrientedGrowth::Gaps;
  b.gap = 1.75;
  b.damping = 6;
  b.spinDamping = 20;
  s.end = 0.15;
  test::Simulation x(s);
  double fastest = 0;
  while (x.w.clock.time < x.w.clock.end) {
    ASSERT_TRUE(x.step());
    const Oriented& o = x.w.oriented.rows;
    for (std::size_t i = 0; i < o.owned; i++) fastest = std::max(fastest, length(o.velocity[i]));
  }
  EXPECT_GT(x.w.counters.orientedBirths, 10);
  EXPECT_EQ(x.w.counters.left, 0);
  EXPECT_LT(fastest, 6);
}

/// A film of 2 cm with a fixed rim is drawn down over a post at 0.5 m/s. Returns the largest number of its
/// particles inside the post at one time.
std::int64_t mostInAPost(double overBarrier, std::int64_t& reported) {
  Scene s = test::emptyScene(0.02, {-1, -1, -1}, {1, 1, 1});
  test::addFloor(s).shape = test::boxOf({-0.05, -0.05, -0.435}, {0.05, 0.05, -0.035});
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "film";
  b.source = OrientedSource::Disc;
  b.radius = 0.2;
  b.density = 20;
  b.damping = b.spinDamping = 10;
  b.growth = OrientedGrowth::Gaps;
  OrientedConstraint rim;
  rim.region.kind = ShapeKind::Difference;
  for (const double radius : {0.3, 0.15}) {
    Shape part;
    part.kind = ShapeKind::Sphere;
    part.radius = radius;
    rim.region.parts.push_back(part);
  }
  rim.motion = {{0, {}, {}}, {0.4, {0, 0, -0.2}, {}}};
  b.constraints.push_back(rim);
  s.end = 0.3;
  test::Simulation x(s);
  x.tools.oriented.obstacles[0].barrier *= overBarrier;
  std::int64_t most = 0;
  while (x.w.clock.time < x.w.clock.end) {
    EXPECT_TRUE(x.step());
    std::int64_t in = 0;
    for (std::size_t i = 0; i < x.w.oriented.rows.owned; i++)
      in += x.w.walls.list[0].shape->inside(x.w.oriented.rows.position[i]);
    most = std::max(most, in);
    if (x.w.clock.step % 20 == 0)
      for (const Interpenetration& f :
           findObstacleInterpenetrations(x.w.oriented, x.w.walls, x.w.scene, x.all))
        reported = std::max(reported, f.count);
  }
  EXPECT_LT(std::abs(x.ledgerReport().energyResidual), 0.02 * x.ledgerReport().energyScale);
  return most;
}

// A film stretched over an obstacle stays on it, and grows or tears. If the obstacle passes through the film,
// a warning reports it.
TEST(OrientedObstacle, IsNotDrawnThroughByAStretchedFilm) {
  std::int64_t reported = 0;
  EXPECT_LE(mostInAPost(1, reported), 4) << "for a moment, by less than a quarter of a spacing";
  EXPECT_EQ(reported, 0);
  EXPECT_GT(mostInAPost(0, reported), 10);
  EXPECT_GT(reported, 5);
}

}  // namespace
}  // namespace thaw
