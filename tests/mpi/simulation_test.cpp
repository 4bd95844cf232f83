// SPDX-License-Identifier: Apache-2.0
// Simulation as a program uses it: without a folder, with loads and changes of its own, side by side.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <utility>

#include "core/geometry/basic/shape_error.hpp"
#include "core/terms/extensions.hpp"
#include "io/run/ledger_history.hpp"
#include "io/scene/check_built_scene.hpp"
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

TEST(Simulation, NamesTheForceOfTheProgramInAFailure) {
  Simulation sim = simulationOf(water);
  sim.addForce([](const OutsideLoad& load) {
    for (std::size_t i = 0; i < load.particles.owned; i++) load.force[i].x = 1e30;
  });
  try {
    sim.run();
    FAIL();
  } catch (const BlewUp& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find(" N (outside 1e+30 N, "), std::string::npos) << text;
    EXPECT_EQ(text.find("viscosity 1e+30"), std::string::npos) << text;
  }
}

TEST(Simulation, NamesScenesWithoutAName) {
  try {
    Simulation::fromText("spacing = -1", {});
    FAIL();
  } catch (const SceneErrors& e) {
    EXPECT_NE(std::string(e.what()).find("scene:1:11: error: spacing: must be > 0 m, got -1"),
              std::string::npos)
        << e.what();
  }
  Scene bad;
  bad.spacing = -1;
  try {
    const Simulation refused(bad, {});
    FAIL();
  } catch (const SceneErrors& e) { EXPECT_EQ(std::string(e.what()).rfind("scene: error: ", 0), 0u); }
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("thaw_nameless_" + std::to_string(ranks));
  Simulation sim = Simulation::fromText(water, {.out = folder, .force = true});
  EXPECT_TRUE(std::filesystem::exists(folder / "frames" / "scene_000000.hdf"));
}

TEST(Simulation, KeepsTheOrderOfEdits) {
  Simulation sim = simulationOf(water);
  EXPECT_THROW(sim.endEdit(), std::logic_error);
  sim.beginEdit();
  EXPECT_THROW(sim.beginEdit(), std::logic_error);
  EXPECT_THROW(sim.step(), std::logic_error);
  EXPECT_THROW(sim.finish(), std::logic_error);
  EXPECT_THROW(sim.addForce([](const OutsideLoad&) {}), std::logic_error);
  EXPECT_FALSE(sim.endEdit());
  EXPECT_TRUE(sim.step());
  bool refused = false;
  sim.onStep([&] {
    EXPECT_TRUE(sim.busy());
    EXPECT_THROW(sim.step(), std::logic_error);
    refused = true;
  });
  sim.step();
  EXPECT_TRUE(refused);
}

/// Expects that an edit of the last rank's first row is refused on all ranks and taken back.
void expectRefusedEdit(const char* text, const std::function<void(Continuum&)>& change,
                       const std::string& message) {
  Simulation sim = simulationOf(text);
  Continuum& p = sim.beginEdit();
  int last = p.owned > 0 ? sim.rank() : -1;
  MPI_Allreduce(MPI_IN_PLACE, &last, 1, MPI_INT, MPI_MAX, sim.communicator());
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] += Vec3d{1, 0, 0};
  if (sim.rank() == last) change(p);
  try {
    sim.endEdit();
    FAIL();
  } catch (const std::invalid_argument& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find(message), std::string::npos) << what;
    EXPECT_EQ(what.find("rank " + std::to_string(last)) != std::string::npos, sim.ranks() > 1);
  }
  EXPECT_EQ(sim.ledger().now.momentum.x, 0);
  EXPECT_TRUE(sim.step());
}

TEST(Simulation, RefusesEditsThatAreNotPhysical) {
  expectRefusedEdit(
      water, [](Continuum& p) { p.velocity[0].y = std::nan(""); }, "velocity of row 0 (id ");
  expectRefusedEdit(
      warmPlate, [](Continuum& p) { p.temperature[0] = -5; }, "is -5 K; expected a finite number");
}

TEST(Simulation, KeepsEditsInARetry) {
  Simulation sim = simulationOf((std::string(water) + "[numerics]\nretry_every = 10\n").c_str());
  bool fail = false;
  sim.addForce([&](const OutsideLoad& load) {
    if (std::exchange(fail, false) && load.particles.owned > 0) load.force[0].x = std::nan("");
  });
  sim.runSteps(13);
  Continuum& p = sim.beginEdit();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] += Vec3d{2, 0, 0};
  sim.endEdit();
  fail = true;
  sim.step();
  EXPECT_EQ(sim.steps(), 13);  // back at the edit, not at step 10
  sim.runSteps(3);
  const LedgerReport l = sim.ledger();
  EXPECT_NEAR(l.now.momentum.x, 2 * l.now.mass, 1e-9 * l.now.mass);
}

TEST(Simulation, GoesBackToItsCheckpoint) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::string name = "thaw_restore_" + std::to_string(ranks),
                    folder = std::filesystem::temp_directory_path() / name;
  const auto begin = [&] {
    return Simulation::fromText(water, {.scene = "test", .out = folder, .force = true});
  };
  Simulation sim = begin();
  int calls = 0;
  sim.onStep([&] { calls++; });
  sim.addForce([](const OutsideLoad& load) {
    for (std::size_t i = 0; i < load.particles.owned; i++) load.force[i].x += load.particles.mass[i];
  });
  sim.runSteps(5);
  sim.writeCheckpoint();
  sim.runSteps(5);
  const LedgerReport before = sim.ledger();
  sim.restore();
  EXPECT_EQ(sim.steps(), 5);
  sim.runSteps(5);
  const LedgerReport after = sim.ledger();
  EXPECT_EQ(calls, 15);
  EXPECT_EQ(before.now.momentum.x, after.now.momentum.x);
  EXPECT_EQ(before.now.kinetic, after.now.kinetic);
  EXPECT_THROW(simulationOf(water).restore(), std::logic_error);
}

TEST(Simulation, KeepsItsLedgerOverTime) {
  const std::string text = std::string(water) + "[output]\nevery = 0.01\n";
  Simulation sim = Simulation::fromText(text, {.scene = "test", .history = true});
  sim.runUntil(0.025);
  const LedgerHistory& h = sim.history();
  ASSERT_EQ(h.rows.size(), 4u);  // start, two frames, end
  ASSERT_EQ(h.names.size(), h.rows[0].values.size());
  EXPECT_EQ(h.names[1], "time_s");
  EXPECT_EQ(h.rows[2].values[1], 0.02);
  EXPECT_THROW(simulationOf(water).history(), std::logic_error);
}

TEST(Simulation, HasViewsOfAllTables) {
  const Simulation sim = simulationOf((std::string(water) + "[surface]\n").c_str());
  int surfels = static_cast<int>(sim.surfels().owned);
  MPI_Allreduce(MPI_IN_PLACE, &surfels, 1, MPI_INT, MPI_SUM, sim.communicator());
  EXPECT_GT(surfels, 0);
  EXPECT_EQ(sim.sheets().owned, 0u);
  EXPECT_EQ(sim.oriented().owned, 0u);
}

Scene builtScene() {
  Scene scene;
  scene.spacing = 0.02;
  scene.end = 0.1;
  Material jelly;
  jelly.name = "jelly";
  jelly.young = {1e5, 0};
  scene.materials = {jelly};
  Body cube;
  cube.name = "cube";
  cube.shape.size = {0.1, 0.1, 0.1};
  scene.bodies = {cube};
  return scene;
}

TEST(Simulation, ChecksScenesMadeInCode) {
  const auto messageOf = [](const std::function<void(Scene&)>& change) {
    Scene scene = builtScene();
    change(scene);
    try {
      Simulation(scene, {.scene = "code"}).step();
    } catch (const SceneErrors& e) { return std::string(e.what()); }
    return std::string("accepted");
  };
  EXPECT_EQ(messageOf([](Scene&) {}), "accepted");
  EXPECT_EQ(messageOf([](Scene& s) { s.spacing = -1; }), "code: error: spacing: must be > 0 m, got -1");
  EXPECT_EQ(messageOf([](Scene& s) { s.materials[0].density = -1; }),
            "code: error: material.jelly.density: must be > 0 kg/m^3, got -1");
  EXPECT_NE(messageOf([](Scene& s) {
              s.materials[0].poisson = {0.7, 0};
            }).find("material.jelly.poisson"),
            std::string::npos);
  EXPECT_NE(messageOf([](Scene& s) {
              s.materials[0].young = {std::nan(""), 0};
            }).find("material.jelly.young"),
            std::string::npos);
  EXPECT_EQ(messageOf([](Scene& s) { s.bodies[0].material = 7; }),
            "code: error: body.cube.material: expected the number of a material, of which the scene has 1, "
            "got 7");
  EXPECT_NE(messageOf([](Scene& s) { s.materials.clear(); }).find("body.cube.material"), std::string::npos);
  EXPECT_NE(messageOf([](Scene& s) {
              s.domain.max = {-2, 1, 1};
            }).find("domain.max: must exceed domain.min"),
            std::string::npos);
  EXPECT_NE(messageOf([](Scene& s) { s.bodies.clear(); }).find("nothing to simulate"), std::string::npos);
  Scene flat = builtScene();
  flat.bodies[0].shape.size.x = -1;
  EXPECT_THROW(Simulation(flat, {.scene = "code"}), ShapeError);
}

TEST(Simulation, AcceptsAllScenesOfFilesAsIfMadeInCode) {
  for (const auto& entry : std::filesystem::directory_iterator(THAW_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(checkBuiltScene(readScene(entry.path().string()), "code")) << entry.path();
  }
}

}  // namespace
}  // namespace thaw
