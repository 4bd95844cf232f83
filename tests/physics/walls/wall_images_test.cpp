// SPDX-License-Identifier: Apache-2.0
// Obstacles across periodic sides act the same on both sides.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 1.0 / 64;
const Vec3d period{24 * dx, 24 * dx, 0};

/// Periodic along x and y, 24 spacings wide.
Scene basin() {
  Scene s = emptyScene(dx, {0, 0, 0}, {period.x, period.y, 40 * dx});
  s.domain.side[0] = s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.numerics.precision = Precision::Double;
  s.materials.resize(2);
  s.materials[0].name = "water";
  s.materials[0].soundSpeed = 20;
  s.materials[0].viscosity = {1, 1};
  s.materials[1].name = "rubber";
  s.materials[1].young = {1e5, 1e5};
  s.materials[1].law.name = "neo-hookean";
  for (Material& m : s.materials) m.conductivity = {50, 50};
  return s;
}

Obstacle& addObstacle(Scene& s, const Vec3d& low, const Vec3d& high) {
  s.obstacles.emplace_back();
  s.obstacles.back().name = "box" + std::to_string(s.obstacles.size());
  s.obstacles.back().shape = boxOf(low, high);
  return s.obstacles.back();
}

/// A hot post with water on the floor around it, and a moving post with a block of rubber on it. The block
/// has its own velocity.
Scene postsIn(const Vec3d& shift) {
  Scene s = basin();
  addObstacle(s, Vec3d{8 * dx, 8 * dx, 0} + shift, Vec3d{12 * dx, 12 * dx, 20 * dx} + shift).temperature =
      350;
  Obstacle& plate = addObstacle(s, Vec3d{16 * dx, 6 * dx, 12 * dx} + shift,
                                Vec3d{22 * dx, 14 * dx, 14 * dx} + shift);
  plate.motion = {{0, {}, {}}, {1, {4 * dx, 0, 8 * dx}, {}}};
  addBox(s, Vec3d{5 * dx, 6 * dx, 0} + shift, Vec3d{8 * dx, 14 * dx, 8 * dx} + shift);
  Body& block = addBox(s, Vec3d{17 * dx, 7 * dx, 14 * dx} + shift, Vec3d{21 * dx, 11 * dx, 18 * dx} + shift);
  block.material = 1;
  block.velocity = {-0.5, 0.2, -0.3};
  return s;
}

struct State {
  Vec3d position, velocity;
  double temperature;
};

/// State by id after some steps of fixed length.
std::map<std::uint64_t, State> after(int steps, Scene s) {
  s.numerics.fixedStep = 1e-4;
  s.end = 1;
  Simulation run(s);
  for (int k = 0; k < steps; k++) EXPECT_TRUE(run.step());
  std::map<std::uint64_t, State> found;
  const Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    found[p.id[i]] = {p.position[i], p.velocity[i], p.temperature.active ? p.temperature[i] : 0};
  return found;
}

/// Distance (m) between two positions less `shift`, modulo whole periods.
double apart(const Vec3d& x, const Vec3d& y, const Vec3d& shift) {
  Vec3d d = x - y - shift;
  for (int a = 0; a < 3; a++)
    if (period[a] > 0) d[a] -= period[a] * std::round(d[a] / period[a]);
  return length(d);
}

struct Difference {
  double place = 0, speed = 0, temperature = 0;
};
Difference between(const std::map<std::uint64_t, State>& a, const std::map<std::uint64_t, State>& b,
                   const Vec3d& shift) {
  EXPECT_EQ(a.size(), b.size());
  Difference most;
  for (const auto& [id, x] : a) {
    const State& y = b.at(id);
    most.place = std::max(most.place, apart(y.position, x.position, shift));
    most.speed = std::max(most.speed, length(y.velocity - x.velocity));
    most.temperature = std::max(most.temperature, std::abs(y.temperature - x.temperature));
  }
  return most;
}

void expectSame(const Difference& d) {
  EXPECT_LT(d.place, 1e-9);
  EXPECT_LT(d.speed, 1e-7);
  EXPECT_LT(d.temperature, 1e-7);
}

}  // namespace

TEST(WallImages, SceneMovedByHalfAPeriodIsTheSame) {
  const Vec3d half{0.5 * period.x, 0.5 * period.y, 0};
  const auto still = after(150, postsIn({})), moved = after(150, postsIn(half));
  expectSame(between(still, moved, half));
  const auto [post, none] = std::pair{after(150, postsIn({})), after(150, [] {
                                        Scene s = postsIn({});
                                        s.obstacles.clear();
                                        return s;
                                      }())};
  const Difference effect = between(none, post, {});
  EXPECT_GT(effect.speed, 0.01);  // the obstacles have an effect
}

TEST(WallImages, ObstacleAPeriodAwayIsTheSame) {
  Scene away = postsIn({});
  for (Obstacle& o : away.obstacles) o.shape.move += Vec3d{-period.x, 2 * period.y, 0};
  expectSame(between(after(100, postsIn({})), after(100, away), {}));
}

TEST(WallImages, ActOnOrientedParticles) {
  const auto place = [](const Vec3d& off) {
    Scene s = basin();
    s.materials.clear();
    addObstacle(s, Vec3d{8 * dx, 8 * dx, 0} + off, Vec3d{16 * dx, 16 * dx, 10 * dx} + off);
    s.oriented.emplace_back();
    OrientedBody& film = s.oriented.back();
    film.name = "film";
    film.source = OrientedSource::Patch;
    film.width = film.depth = 6 * dx;
    film.shape.move = {12 * dx, 12 * dx, 12 * dx};
    s.end = 0.1;
    return s;
  };
  Simulation here(place({})), there(place({-period.x, period.y, 0})), none(place({0, 0, -1}));
  ASSERT_TRUE(here.run() && there.run() && none.run());
  const BodyTypeRows &a = here.w.oriented.rows, &b = there.w.oriented.rows, &c = none.w.oriented.rows;
  ASSERT_EQ(a.owned, b.owned);
  for (std::size_t i = 0; i < a.owned; i++) {
    EXPECT_LT(length(a.position[i] - b.position[i]), 1e-9);
    EXPECT_GT(a.position[i].z, 10 * dx);
  }
  EXPECT_LT(c.position[0].z, 9.5 * dx);  // without the obstacle it falls below its top
}

TEST(WallImages, RefuseEmittersAndBodiesInside) {
  Scene s = basin();
  addObstacle(s, {-4 * dx, 8 * dx, 0}, {4 * dx, 16 * dx, 10 * dx});  // beyond the low side along x
  addBox(s, {10 * dx, 8 * dx, 0}, {14 * dx, 12 * dx, 4 * dx});
  EXPECT_NO_THROW(Simulation{s});
  Scene body = s;
  addBox(body, {21 * dx, 9 * dx, 0}, {23 * dx, 12 * dx, 4 * dx});
  EXPECT_THROW(Simulation{body}, std::runtime_error);
  Scene emitter = s;
  emitter.emitters.emplace_back();
  emitter.emitters.back().name = "jet";
  emitter.emitters.back().centre = {22 * dx, 12 * dx, 4 * dx};
  emitter.emitters.back().radius = 2 * dx;
  EXPECT_THROW(Simulation{emitter}, std::runtime_error);
}

}  // namespace thaw::test
