// SPDX-License-Identifier: Apache-2.0
// Simulation as a program uses it: without a folder, with loads and changes of its own, side by side.
#include <gtest/gtest.h>

#include <cmath>

#include "core/domain/extensions.hpp"
#include "io/scene/read_scene.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace thaw {
namespace {

constexpr const char* water = R"(
spacing = 0.05
end = 1
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.water]
density = 1000
sound_speed = 20
[[body]]
name = "drop"
sphere = { radius = 0.3 }
material = "water"
)";

constexpr const char* warmPlate = R"(
spacing = 0.05
end = 1
[domain]
min = [0, 0, 0]
max = [0.4, 0.4, 0.4]
gravity = [0, 0, 0]
[material.plate]
density = 1000
young = 1e5
heat_capacity = 100
conductivity = 1
heat_source = 1e-9
[[body]]
name = "plate"
box = { size = [0.3, 0.3, 0.1] }
place = { move = [0.2, 0.2, 0.2] }
temperature = 300
material = "plate"
)";

Simulation simulationOf(const char* text) { return Simulation::fromText(text, {.scene = "test"}); }

/// Relative residual of mechanical energy.
double residual(const LedgerReport& l) { return std::abs(l.energyResidual) / l.energyScale; }

TEST(Simulation, StepsWithoutAFolder) {
  Simulation sim = simulationOf(water);
  sim.runSteps(10);
  EXPECT_EQ(sim.steps(), 10);
  sim.runUntil(0.05);
  EXPECT_EQ(sim.time(), 0.05);
  EXPECT_THROW(sim.writeFrame(), std::logic_error);
  const LedgerReport l = sim.ledger();
  EXPECT_NEAR(l.now.momentum.z, -9.81 * 0.05 * l.now.mass, 1e-9 * l.now.mass);
}

TEST(Simulation, RecordsForcesOfTheProgram) {
  Simulation sim = simulationOf(water);
  sim.addForce([](const OutsideLoad& load) {
    for (std::size_t i = 0; i < load.particles.owned; i++)
      load.force[i] += load.particles.position[i] * (-400 * load.particles.mass[i]);
  });
  sim.runUntil(0.1);
  const LedgerReport l = sim.ledger();
  EXPECT_GT(std::abs(l.wallWork), 0.1 * l.now.kinetic);
  EXPECT_LT(residual(l), 0.01);
  EXPECT_LT(length(l.momentumResidual), 1e-9 * l.now.mass);
}

/// A thick liquid between plates, with implicit viscosity.
constexpr const char* channel = R"(
spacing = 0.05
end = 1
[domain]
min = [0, 0, 0]
max = [0.3, 0.3, 0.6]
gravity = [0, 0, 0]
sides = { x = "periodic", y = "periodic", z = "wall" }
[numerics]
viscosity_solver = "implicit"
max_step = "2 ms"
[material.oil]
density = 1000
viscosity = 500
sound_speed = 10
[[body]]
name = "oil"
box = { size = [0.3, 0.3, 0.6] }
place = { move = [0.15, 0.15, 0.3] }
material = "oil"
)";

TEST(Simulation, ForcesActWithinTheImplicitViscosity) {
  const auto momentum = [](double gravity, double load) {
    std::string text = channel;
    const std::string none = "gravity = [0, 0, 0]";
    text.replace(text.find(none), none.size(), "gravity = [" + std::to_string(gravity) + ", 0, 0]");
    Simulation sim = simulationOf(text.c_str());
    sim.addForce([load](const OutsideLoad& l) {
      for (std::size_t i = 0; i < l.particles.owned; i++) l.force[i].x += load * l.particles.mass[i];
    });
    sim.runSteps(60);
    return sim.ledger().now.momentum.x;
  };
  const double byWeight = momentum(8, 0), byLoad = momentum(0, 8);
  EXPECT_GT(byWeight, 0);
  EXPECT_NEAR(byLoad / byWeight, 1, 1e-3);  // the load begins half a step later
}

TEST(Simulation, RecordsChangesOfVelocity) {
  Simulation sim = simulationOf(water);
  sim.runSteps(5);
  Continuum& p = sim.beginEdit();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] += Vec3d{2, 0, 0};
  EXPECT_TRUE(sim.endEdit());
  sim.beginEdit();
  EXPECT_FALSE(sim.endEdit());  // nothing changed
  sim.runSteps(5);
  const LedgerReport l = sim.ledger();
  EXPECT_NEAR(l.now.momentum.x, 2 * l.now.mass, 1e-9 * l.now.mass);
  EXPECT_NEAR(l.wallWork, 0.5 * 4 * l.now.mass, 0.02 * l.now.mass);
  EXPECT_LT(residual(l), 1e-3);
  EXPECT_LT(length(l.momentumResidual), 1e-9 * l.now.mass);
}

TEST(Simulation, RecordsHeatAndTemperaturesOfTheProgram) {
  Simulation sim = simulationOf(warmPlate);
  const double before = sim.ledger().now.internal;
  sim.addForce([](const OutsideLoad& load) {
    for (std::size_t i = 0; i < load.particles.owned; i++) load.heat[i] += 5 * load.particles.mass[i];
  });
  sim.runUntil(0.01);
  Continuum& p = sim.beginEdit();
  for (std::size_t i = 0; i < p.owned; i++) p.temperature[i] += 10;
  EXPECT_TRUE(sim.endEdit());
  sim.runUntil(0.02);
  const LedgerReport l = sim.ledger();
  EXPECT_NEAR(l.now.internal - before, l.now.mass * (5 * 0.02 + 100 * 10), 1e-3 * l.now.mass);
  EXPECT_LT(std::abs(l.heatResidual), 1e-9 * l.heatScale);
}

/// Registers a trap with the key omega, once a process.
void registerTrap() {
  if (findExtension("trap")) return;
  Extension trap;
  trap.name = "trap";
  trap.about = "a force towards the origin";
  trap.keys = {{"omega", "1/s", 10, 0, 1e6, "frequency of the trap"}};
  trap.load = [](const ExtensionSettings& settings) {
    const double stiffness = std::pow(settings.values.at("omega"), 2);
    return [stiffness](const OutsideLoad& load) {
      const Continuum& p = load.particles;
      for (std::size_t i = 0; i < p.owned; i++) load.force[i] -= p.position[i] * (stiffness * p.mass[i]);
    };
  };
  trap.stepLimit = [](const ExtensionSettings& settings) { return 0.1 / settings.values.at("omega"); };
  registerExtension(trap);
}

TEST(Extensions, HaveKeysInScenes) {
  registerTrap();
  Simulation sim = simulationOf((std::string(water) + "[extension.trap]\nomega = \"40 1/s\"\n").c_str());
  EXPECT_EQ(sim.scene().extensions.at(0).values.at("omega"), 40);
  sim.runUntil(0.05);
  EXPECT_LE(sim.lastStep(), 0.1 / 40);
  const LedgerReport l = sim.ledger();
  EXPECT_GT(std::abs(l.wallWork), 0.1 * l.now.kinetic);
  EXPECT_LT(residual(l), 0.01);
}

TEST(Extensions, AreRefusedWithTheirPlace) {
  registerTrap();
  const auto messageOf = [](const std::string& table) {
    try {
      simulationOf((std::string(water) + table).c_str());
    } catch (const SceneErrors& e) { return std::string(e.what()); }
    return std::string("accepted");
  };
  EXPECT_NE(messageOf("[extension.trap]\nomega = -1\n").find("extension.trap.omega: must be"),
            std::string::npos);
  EXPECT_NE(messageOf("[extension.trap]\nomegas = 1\n").find("unknown key 'omegas'"), std::string::npos);
  EXPECT_NE(messageOf("[extension.tarp]\n").find("unknown extension; this program has trap"),
            std::string::npos);
  EXPECT_THROW(registerExtension({"trap", "", {}, findExtension("trap")->load, {}}), std::invalid_argument);
  EXPECT_THROW(registerExtension({"no name", "", {}, findExtension("trap")->load, {}}),
               std::invalid_argument);
}

TEST(Simulation, StopsAtTheRequestOfOneRank) {
  Simulation sim = simulationOf(water);
  sim.onStep([&sim] {
    if (sim.steps() == 3 && sim.rank() == sim.ranks() - 1) sim.requestStop();
  });
  sim.run();
  EXPECT_TRUE(sim.stopped());
  EXPECT_EQ(sim.steps(), 4);
  EXPECT_FALSE(sim.step());
  sim.resume();
  EXPECT_TRUE(sim.step());
}

TEST(Simulation, RunsSideBySide) {
  Simulation one = simulationOf(water), two = simulationOf(water), alone = simulationOf(water);
  alone.runSteps(6);
  for (int n = 0; n < 6; n++) {
    one.step();
    two.step();
  }
  for (const Simulation* s : {&one, &two}) {
    const Continuum &p = s->world().particles, &q = alone.world().particles;
    ASSERT_EQ(p.owned, q.owned);
    for (std::size_t i = 0; i < p.owned; i++) {
      EXPECT_EQ(p.id[i], q.id[i]);
      EXPECT_EQ(p.position[i].z, q.position[i].z);
    }
  }
}

TEST(Simulation, RefusesBadScenesWithTheirPlace) {
  try {
    simulationOf("spacing = -1");
    FAIL();
  } catch (const SceneErrors& e) {
    EXPECT_NE(std::string(e.what()).find("test:1:11: error: spacing: must be > 0 m, got -1"),
              std::string::npos);
  }
  EXPECT_THROW(Simulation({.scene = "absent.toml"}), SceneErrors);
}

}  // namespace
}  // namespace thaw
