// SPDX-License-Identifier: Apache-2.0
// Obstacles that a program moves, and the loads on them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "io/simulation/driven_obstacle.hpp"
#include "parallel/communicator.hpp"

namespace thaw {
namespace {

/// A pool of water on a plate that a program may move; no other walls.
const std::string pool = R"(
spacing = 0.05
end = 1
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.water]
density = 1000
viscosity = "1 Pa s"
sound_speed = 20
[[body]]
name = "drop"
sphere = { radius = 0.25 }
place = { move = [0.02, 0, 0.24] }
material = "water"
[[obstacle]]
name = "plate"
box = { size = [1, 1, 0.2] }
place = { move = [0, 0, -0.1] }
motion = [{ time = 0 }]
)";

Simulation simulationOf(const std::string& text, MPI_Comm comm = MPI_COMM_WORLD) {
  return Simulation::fromText(text, {.scene = "test"}, comm);
}

/// The pool after a change of its text.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = pool;
  return text.replace(text.find(from), from.size(), to);
}

std::string refusal(const std::string& text, const std::string& name) {
  Simulation sim = simulationOf(text);
  try {
    DrivenObstacle(sim, name);
  } catch (const std::invalid_argument& e) { return e.what(); }
  return "";
}

void lift(Simulation& sim, DrivenObstacle& plate, double speed) {
  sim.onStep([&sim, &plate, speed] {
    plate.move({.position = {0, 0, speed * sim.time()}, .velocity = {0, 0, speed}});
  });
}

TEST(DrivenObstacle, LoadIsTheReactionInTheLedger) {
  Simulation sim = simulationOf(pool, MPI_COMM_SELF);
  DrivenObstacle plate(sim, "plate");
  EXPECT_EQ(plate.load().force, Vec3d{});
  for (int n = 0; n < 5; n++) {
    sim.runSteps(5);
    const ObstacleLoad load = plate.load();
    for (int a = 0; a < 3; a++) EXPECT_EQ(load.force[a], -sim.world().ledger.wallForce[a].value());
    EXPECT_LT(load.force.z, -1);
    EXPECT_GT(load.torque.y, 0.01 * std::abs(load.force.z));  // the drop lies at x = 0.02 m
  }
}

TEST(DrivenObstacle, WorkOfAMotionIsForceTimesWay) {
  Simulation sim = simulationOf(pool, MPI_COMM_SELF);
  DrivenObstacle plate(sim, "plate");
  constexpr double speed = 0.5;  // m/s
  lift(sim, plate, speed);
  plate.move({.velocity = {0, 0, speed}});
  double work = 0;
  sim.onStep([&] { work -= plate.load().force.z * speed * sim.lastStep(); });
  sim.runUntil(0.1);
  EXPECT_NEAR(plate.pose().move.z, 0.05, 1e-12);
  const LedgerReport ledger = sim.ledger();
  EXPECT_GT(work, 1);
  EXPECT_NEAR(ledger.wallWork, work, 1e-9 * work);
  EXPECT_LT(std::abs(ledger.energyResidual), 0.01 * ledger.energyScale);
}

TEST(DrivenObstacle, RotationMovesItsSurface) {
  Simulation sim = simulationOf(pool, MPI_COMM_SELF);
  DrivenObstacle plate(sim, "plate");
  plate.move({.position = {0, 0, -0.5}, .rotationRate = {0, 0, 2}});
  const Vec3d v = velocityAt(plate.pose(), {0.1, 0, -0.5});
  EXPECT_NEAR(v.y, 0.2, 1e-9);
  sim.runSteps(3);
  EXPECT_NEAR(plate.pose().rotate.z, 2 * sim.time(), 1e-9);
  EXPECT_EQ(plate.load().force, Vec3d{});  // out of reach
}

TEST(DrivenObstacle, SameBitsOnAnyNumberOfRanks) {
  Simulation one = simulationOf(pool, MPI_COMM_SELF), all = simulationOf(pool);
  DrivenObstacle plateOfOne(one, "plate"), plateOfAll(all, "plate");
  lift(one, plateOfOne, 0.3);
  lift(all, plateOfAll, 0.3);
  one.runSteps(20);
  all.runSteps(20);
  const ObstacleLoad a = plateOfOne.load(), b = plateOfAll.load();
  EXPECT_EQ(one.time(), all.time());
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.torque, b.torque);
  EXPECT_EQ(one.ledger().wallWork, all.ledger().wallWork);
}

TEST(DrivenObstacle, RefusesWhatItCannotDrive) {
  EXPECT_EQ(refusal(pool, "plate"), "");
  EXPECT_EQ(refusal(pool, "late"), "unknown obstacle 'late'; the scene has 'plate'");
  const std::string motion = "motion = [{ time = 0 }]\n";
  EXPECT_EQ(refusal(changed(motion, ""), "plate"),
            "obstacle 'plate' is static: give it a keyframe, motion = [{ time = 0 }]");
  EXPECT_EQ(refusal(changed("max = [1, 1, 1]\n", "max = [1, 1, 1]\nsides = { x = \"periodic\" }\n"), "plate"),
            "obstacle 'plate' cannot be driven: it is shorter than the periodic domain");
  const std::string tension = "surface_tension = 0.07\ncontact_angle = 1\n";
  EXPECT_EQ(refusal(changed("[[body]]", tension + "[[body]]"), "plate"),
            "obstacle 'plate' cannot be driven: its load by contact angles is unknown");
}

TEST(DrivenObstacle, RefusesMotionThatIsNotFinite) {
  Simulation sim = simulationOf(pool);
  DrivenObstacle plate(sim, "plate");
  EXPECT_THROW(plate.move({.velocity = {0, 0, std::numeric_limits<double>::quiet_NaN()}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace thaw
