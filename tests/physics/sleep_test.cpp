// Solids at rest sleep (core/sleep/): the same motion within what is allowed, nearly no work, and waking by contact, a wall and heat.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

/// A block on a floor that another block, `gap` above it, falls on; a third block stands far away.
Scene blocks(double gap) {
  Scene s = test::emptyScene(0.1, {-2, -2, -0.5}, {6, 2, 6});
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e6, 1e6};
  s.materials[0].density = 1000;
  s.materials[0].damping = 1000;
  s.materials[0].restitution = 0.2;
  test::addBox(s, {-0.5, -0.5, 0.05}, {0.5, 0.5, 0.55});
  test::addBox(s, {-0.3, -0.3, 0.65 + gap}, {0.3, 0.3, 0.95 + gap});
  test::addBox(s, {3.5, -0.5, 0.05}, {4.5, 0.5, 0.55});
  s.end = 2;
  return s;
}

double lowest(const Continuum& p, std::uint16_t body) {
  double z = never;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.body[i] == body) z = std::min(z, p.position[i].z);
  return z;
}

TEST(Sleep, BlocksThatComeToRestSleepAndKeepTheirPlace) {
  Scene s = blocks(0.1);
  test::Simulation awakeOnes(s);
  ASSERT_TRUE(awakeOnes.run());
  s.numerics.sleepSpeed = 0.02;
  s.numerics.sleepAfter = 0.02;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(x.w.counters.asleep, static_cast<std::int64_t>(x.particles().owned));
  for (std::size_t i = 0; i < x.particles().owned; i++) {
    const std::size_t k = i;  // the same cells and ids, where both are at rest
    if (awakeOnes.particles().id[k] != x.particles().id[i]) continue;
    EXPECT_LT(length(awakeOnes.particles().position[k] - x.particles().position[i]), 0.01 * s.spacing);
  }
  const LedgerReport books = x.books();
  EXPECT_LT(std::abs(books.energyResidual - awakeOnes.books().energyResidual), 1e-3 * books.energyScale);
  EXPECT_LT(length(books.momentumResidual), 1e-6 * books.now.mass);
}

TEST(Sleep, ABlockThatFallsOnASleeperWakesItAndNotTheOther) {
  Scene s = blocks(4);
  s.numerics.sleepSpeed = 0.02;
  s.numerics.sleepAfter = 0.02;
  test::Simulation x(s);
  bool slept = false, hit = false;
  while (x.w.clock.time < 1.1) {
    ASSERT_TRUE(x.step());
    const double fast = lowest(x.particles(), 1);
    bool below = true, far = true;
    for (std::size_t i = 0; i < x.particles().owned; i++) {
      if (x.particles().body[i] == 0) below = below && x.particles().sleep[i] != awake;
      if (x.particles().body[i] == 2) far = far && x.particles().sleep[i] != awake;
    }
    if (fast > 0.9) slept = slept || (below && far);
    if (slept && !below && far) hit = true;
  }
  EXPECT_TRUE(slept);
  EXPECT_TRUE(hit);
}

}  // namespace
}  // namespace thaw
