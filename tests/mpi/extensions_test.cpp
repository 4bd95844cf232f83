// SPDX-License-Identifier: Apache-2.0
// Extensions: fields, pair forces, elastic laws, shapes and hooks, with the same bits on any number of ranks
// and after a restart.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include "core/geometry/shapes/primitives.hpp"
#include "core/math/exact_sum.hpp"
#include "core/solid/laws/elastic_constants.hpp"
#include "core/solid/laws/response.hpp"
#include "core/terms/extensions.hpp"
#include "io/scene/read_scene.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"
#include "tests/support/extensions/copies.hpp"
#include "tests/support/extensions/kernels.hpp"

namespace thaw {
namespace {

constexpr const char* drop = R"(
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
sphere = { radius = 0.3 }
material = "water"
velocity = { x = "3 * y", y = "1" }
)";

constexpr const char* block = R"(
spacing = 0.05
end = 1
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
gravity = [0, 0, 0]
[[body]]
name = "block"
box = { size = [0.4, 0.3, 0.3] }
material = "jelly"
velocity = { x = "4 * x", y = "-2 * y + z" }
[material.jelly]
density = 1000
young = "100 kPa"
poisson = 0.35
)";

/// A field that counts time and one that keeps ids.
Extension age() {
  return {.name = "age",
          .about = "time since the start, and the id",
          .fields = {{"age", "s", "time since the start"}, {"tag", "1", "id and 0.5", 2, 0.5}},
          .update = [](const ExtensionSettings&) -> FieldUpdate {
            return [](const FieldStep& step) {
              Continuum& p = step.particles;
              for (std::size_t i = 0; i < p.owned; i++) {
                p.addedField("age")->row(i)[0] += step.dt;
                p.addedField("tag")->row(i)[0] = static_cast<double>(p.id[i]);
              }
            };
          }};
}

/// Springs whose first value is 1 + z / m at the start (field `charge`).
Extension springs() {
  return {.name = "springs",
          .about = "springs between liquid particles",
          .keys = {{"stiffness", "J", 0.01, 0, 1e3, ""}, {"drag", "kg/s", 0, 0, 1e3, ""}},
          .fields = {{"charge", "1", "factor of the springs", 1, 1.0, true}},
          .pairForce = {.kernels = test::extensionKernels()->spring, .pack = [](const PairPacking& to) {
                          const AddedColumn& charge = *to.particles.addedField("charge");
                          for (std::size_t i = to.begin; i < to.end; i++)
                            to.values[i - to.begin].x = charge.row(i)[0];
                        }}};
}

/// The Neo-Hookean law by a function of one particle.
Extension scalarCopyOfNeoHookean() {
  return {
      .name = "scalar_copy",
      .about = "Neo-Hookean",
      .law = {.response = [](const Mat3d& gradU, double lambda, double mu, const LawValues&) -> LawResponse {
        ElasticConstants c;
        c.lambda = lambda, c.mu = mu,
        c.law = &boundLaw(ExtensionSettings{.name = "neo-hookean", .values = {}});
        const ElasticResponse r = elasticResponse(c, gradU);
        return {r.energy, r.stress};
      }}};
}

/// A force along gravity on the particles on one side of a moving obstacle, over the mass of all particles.
/// It reads the scene, the walls, and a sum over all ranks.
Extension shade() {
  return {.name = "shade", .about = "a force below an obstacle", .load = [](const ExtensionSettings&) {
            return [](const OutsideLoad& load) {
              const Continuum& p = load.particles;
              ExactSum mass;
              for (std::size_t i = 0; i < p.owned; i++) mass.add(p.mass[i]);
              mass.carry();
              load.all.sum(mass.digit);
              const Wall& lid = load.walls.list[0];
              for (std::size_t i = 0; i < p.owned; i++)
                if (p.position[i].x < lid.pose.move.x)
                  load.force[i] += load.run.scene.domain.gravity *
                                   (p.mass[i] * p.mass[i] / mass.value() * (load.dt > 0 ? 100 : 0));
            };
          }};
}

void registerAll() {
  if (findExtension("age")) return;
  registerExtension(shade());
  for (Extension e : {age(), springs(), test::copyOfTension(), test::copyOfNeoHookean(),
                      test::singleCopyOfNeoHookean(), scalarCopyOfNeoHookean(), test::copyOfBall()})
    registerExtension(std::move(e));
}

Simulation simulationOf(const std::string& text, MPI_Comm comm = MPI_COMM_WORLD,
                        const RunOptions& options = {}) {
  registerAll();
  RunOptions o = options;
  o.scene = "test";
  return Simulation::fromText(text, o, comm);
}

/// Position, velocity and added fields by id, of this rank.
std::map<std::uint64_t, std::vector<double>> stateOf(const Simulation& sim) {
  std::map<std::uint64_t, std::vector<double>> state;
  const Continuum& p = sim.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    std::vector<double>& row = state[p.id[i]];
    for (int a = 0; a < 3; a++) row.push_back(p.position[i][a]), row.push_back(p.velocity[i][a]);
    for (const auto& c : p.added) row.insert(row.end(), c->row(i), c->row(i) + c->components);
  }
  return state;
}

/// The same for the particles of all ranks, on each rank, since partitions differ between runs. Collective.
std::map<std::uint64_t, std::vector<double>> wholeStateOf(const Simulation& sim) {
  std::vector<double> mine, all;
  for (const auto& [id, row] : stateOf(sim)) {
    mine.push_back(std::bit_cast<double>(id));
    mine.push_back(static_cast<double>(row.size()));
    mine.insert(mine.end(), row.begin(), row.end());
  }
  std::vector<int> counts(static_cast<std::size_t>(sim.ranks())), first(counts.size());
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, sim.communicator());
  std::exclusive_scan(counts.begin(), counts.end(), first.begin(), 0);
  all.resize(static_cast<std::size_t>(first.back()) + static_cast<std::size_t>(counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), first.data(), MPI_DOUBLE,
                 sim.communicator());
  std::map<std::uint64_t, std::vector<double>> state;
  for (std::size_t k = 0; k < all.size(); k += 2 + static_cast<std::size_t>(all[k + 1])) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(k) + 2;
    state[std::bit_cast<std::uint64_t>(all[k])].assign(begin,
                                                       begin + static_cast<std::ptrdiff_t>(all[k + 1]));
  }
  return state;
}

/// Expects the bits of `alone`, a run on one rank, for all particles of this rank.
void expectSameBits(const Simulation& sim, const Simulation& alone) {
  const auto all = stateOf(alone), mine = stateOf(sim);
  std::size_t different = 0;
  for (const auto& [id, row] : mine) different += all.at(id) != row;
  EXPECT_EQ(different, 0u);
  std::uint64_t count = mine.size(), total = 0;
  MPI_Allreduce(&count, &total, 1, MPI_UINT64_T, MPI_SUM, sim.communicator());
  EXPECT_EQ(total, all.size());
}

std::string messageOf(const std::string& text) {
  try {
    simulationOf(text);
  } catch (const std::exception& e) { return e.what(); }
  return "accepted";
}

TEST(ExtensionLoads, ReadTheSceneTheWallsAndSumsOverRanks) {
  const std::string text = std::string(drop) +
                           "[extension.shade]\n[[obstacle]]\nname = \"lid\"\n"
                           "box = { size = [0.1, 0.1, 0.1] }\nplace = { move = [0, 0, 0.8] }\n"
                           "motion = [{ time = 0, move = [-0.5, 0, 0] }, { time = 1, move = [4, 0, 0] }]\n";
  Simulation sim = simulationOf(text), alone = simulationOf(text, MPI_COMM_SELF),
             without = simulationOf(drop, MPI_COMM_SELF);
  for (Simulation* s : {&sim, &alone, &without}) s->runUntil(0.1);
  expectSameBits(sim, alone);
  EXPECT_NE(stateOf(alone), stateOf(without));
  const LedgerReport l = alone.ledger();
  EXPECT_LT(std::abs(l.energyResidual), 1e-3 * l.energyScale);
}

TEST(ExtensionFields, MoveWithTheirParticles) {
  const std::string text = std::string(drop) + "[extension.age]\n";
  Simulation sim = simulationOf(text);
  double age = 0;
  sim.onStep([&] { age += sim.lastStep(); });
  sim.runUntil(0.15);
  const Continuum& p = sim.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    ASSERT_EQ(p.addedField("age")->row(i)[0], age);
    ASSERT_EQ(p.addedField("tag")->row(i)[0], static_cast<double>(p.id[i]));
    ASSERT_EQ(p.addedField("tag")->row(i)[1], 0.5);
  }
  Simulation alone = simulationOf(text, MPI_COMM_SELF);
  alone.runUntil(0.15);
  expectSameBits(sim, alone);
}

TEST(ExtensionFields, AreOnlyWhereTheSceneNamesThem) {
  const Simulation sim = simulationOf(drop, MPI_COMM_SELF);
  EXPECT_EQ(sim.particles().addedField("age"), nullptr);
  EXPECT_NE(messageOf(std::string(drop) + "[output]\nfields = [\"age\"]\n").find("output.fields"),
            std::string::npos);
}

TEST(ExtensionFields, ContinueAfterARestart) {
  const std::string text =
      std::string(drop) +
      "[extension.age]\n[extension.springs]\ndrag = 0.01\n[output]\nevery = 0.02\nfields = "
      "[\"age\", \"tag\", \"charge\"]\n";
  std::string out = THAW_BINARY_DIR "/tests/extensions_restart";
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  out += std::to_string(ranks);
  RunOptions options;
  options.out = out;
  options.force = true;
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::filesystem::remove_all(out);
  MPI_Barrier(MPI_COMM_WORLD);
  {
    Simulation first = simulationOf(text, MPI_COMM_WORLD, options);
    first.runSteps(15);
    first.finish();
  }
  options.restart = true;
  Simulation second = simulationOf(text, MPI_COMM_WORLD, options);
  second.runSteps(15);
  Simulation alone = simulationOf(text, MPI_COMM_SELF);
  alone.runSteps(30);
  expectSameBits(second, alone);
  EXPECT_EQ(second.steps(), 30);
  second.finish();
  const auto without = [&](const std::string& scene) {
    try {
      simulationOf(scene, MPI_COMM_WORLD, options);
    } catch (const std::exception& e) { return std::string(e.what()); }
    return std::string("accepted");
  };
  EXPECT_NE(without(std::string(drop) + "[extension.springs]\ndrag = 0.01\n[output]\nevery = 0.02\n")
                .find("extension.age is not in the scene any more"),
            std::string::npos);
}

TEST(PairForces, HaveTheSameBitsOnAnyNumberOfRanks) {
  const std::string text = std::string(drop) + "[extension.springs]\nstiffness = 0.02\ndrag = 0.05\n";
  Simulation sim = simulationOf(text), alone = simulationOf(text, MPI_COMM_SELF);
  sim.runSteps(25);
  alone.runSteps(25);
  expectSameBits(sim, alone);
}

TEST(PairForces, EqualTheSumOverAllPairs) {
  for (const char* precision : {"single", "double"}) {
    Simulation with = simulationOf(std::string(drop) +
                                       "[extension.springs]\nstiffness = 0.02\ndrag = 0.05\n" +
                                       "[numerics]\nprecision = \"" + precision + "\"\n",
                                   MPI_COMM_SELF);
    const Continuum& p = with.particles();
    const double h = with.world().grid.support, tolerance = std::string(precision) == "single" ? 2e-5 : 1e-11;
    const PairForceKernels spring = test::extensionKernels()->spring;
    const double values[2] = {0.02, 0.05};
    double energy = 0, stored = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      for (std::size_t j = 0; j < i; j++) {
        const double one[4] = {1, 0, 0, 1};
        energy += spring.energy({values, h, 0.05}, {p.position[i] - p.position[j], one, one});
        const double q = length(p.position[i] - p.position[j]) / h;
        if (q < 1) stored += 0.5 * 0.02 * (1 - q) * (1 - q);
      }
    Simulation without = simulationOf(std::string(drop) + "[numerics]\nprecision = \"" + precision + "\"\n",
                                      MPI_COMM_SELF);
    const double more = with.ledger().now.potential - without.ledger().now.potential;
    EXPECT_NEAR(energy, stored, 1e-12 * stored);
    EXPECT_NEAR(more, stored, tolerance * stored);
  }
}

TEST(PairForces, ConserveMomentumAndEnergy) {
  Simulation sim = simulationOf(std::string(drop) + "[extension.springs]\nstiffness = 0.02\ndrag = 0.02\n");
  const LedgerReport before = sim.ledger();
  sim.runUntil(0.1);
  const LedgerReport l = sim.ledger();
  EXPECT_LT(length(l.momentumResidual), 1e-9 * l.now.mass);
  EXPECT_LT(std::abs(l.energyResidual), 0.01 * l.energyScale);
  EXPECT_GT(l.dissipated, before.dissipated);
}

TEST(PairForces, RecordWhatLeavesThroughOpenSides) {
  std::string text = drop;
  text.replace(text.find("max = [1, 1, 1]"), 15, "max = [1, 0.31, 1]");
  Simulation sim = simulationOf(text + "[extension.springs]\nstiffness = 0.05\n");
  sim.runUntil(0.2);
  const LedgerReport l = sim.ledger();
  EXPECT_LT(l.particles, 900);
  EXPECT_LT(std::abs(l.energyResidual), 0.01 * l.energyScale);
}

TEST(PairForces, CopyOfTensionFollowsTheBuiltIn) {
  std::string built = drop;
  built.replace(built.find("sound_speed"), 0, "surface_tension = 1\n");
  const std::string pairs =
      "[numerics]\ntension = \"pairwise\"\nfixed_step = 5e-4\ndensity = \"summation\"\nshifting = 0\n"
      "viscosity_correction = false\n";
  Simulation one = simulationOf(built + pairs, MPI_COMM_SELF),
             two = simulationOf(drop + pairs + "[extension.copy_of_tension]\n", MPI_COMM_SELF);
  one.runSteps(40);
  two.runSteps(40);
  const auto a = wholeStateOf(one), b = wholeStateOf(two);
  double worst = 0;
  for (const auto& [id, row] : a)
    for (std::size_t k = 0; k < 6; k++) worst = std::max(worst, std::abs(row[k] - b.at(id)[k]));
  EXPECT_LT(worst, 1e-4);  // speeds are up to 3 m/s, in single precision
  EXPECT_NEAR(one.ledger().now.potential, two.ledger().now.potential, 1e-4);
}

TEST(PairForces, RecordWhatEmittersBring) {
  const std::string text = std::string(drop) + R"([[emitter]]
name = "tap"
disc = { radius = 0.12 }
centre = [0, 0, 0.45]
speed = 2
material = "water"
end = 0.1
[extension.springs]
stiffness = 0.02
)";
  Simulation sim = simulationOf(text), alone = simulationOf(text, MPI_COMM_SELF);
  sim.runUntil(0.15);
  alone.runUntil(0.15);
  expectSameBits(sim, alone);
  const LedgerReport l = sim.ledger();
  EXPECT_GT(l.particles, 950);
  EXPECT_GT(l.entered.potential, 0);
  EXPECT_LT(std::abs(l.energyResidual), 0.01 * l.energyScale);
}

TEST(PairForces, AreRefusedWithoutLiquid) {
  EXPECT_NE(messageOf(std::string(block) + "[extension.springs]\n").find("between liquid particles"),
            std::string::npos);
}

Simulation blockWith(const std::string& law, const std::string& more = "") {
  return simulationOf(std::string(block) + "law = \"" + law + "\"\n" + more, MPI_COMM_SELF);
}

/// Largest difference of positions (m) and velocities (m/s) of two runs.
double differenceOf(const Simulation& one, const Simulation& two) {
  const auto a = wholeStateOf(one), b = wholeStateOf(two);
  double worst = 0;
  for (const auto& [id, row] : a)
    for (std::size_t k = 0; k < row.size(); k++) worst = std::max(worst, std::abs(row[k] - b.at(id)[k]));
  return worst;
}

TEST(ExtensionLaws, CopyOfNeoHookeanEqualsTheBuiltIn) {
  for (const std::string more : {"", "yield_strain = 0.02\n"}) {
    Simulation built = blockWith("neo-hookean", more), copy = blockWith("copy", more),
               scalar = blockWith("scalar_copy", more);
    built.runSteps(60), copy.runSteps(60), scalar.runSteps(60);
    EXPECT_LT(differenceOf(built, copy), 1e-12) << more;
    EXPECT_LT(differenceOf(built, scalar), 1e-12) << more;
    EXPECT_NEAR(built.ledger().now.elastic, copy.ledger().now.elastic, 1e-12);
    EXPECT_GT(built.ledger().now.elastic, 0.01);
  }
}

/// A copy of the Neo-Hookean law, with the precision of bonds for which it gives the bits of the library.
struct LawCopy {
  std::string name, numerics;
};
const std::array<LawCopy, 2> lawCopies{{{"copy", "[numerics]\nelastic_precision = \"double\"\n"},
                                        {"single_copy", "[numerics]\nelastic_precision = \"single\"\n"}}};

TEST(ExtensionLaws, HaveTheBitsOfTheBuiltIn) {
  for (const LawCopy& c : lawCopies) {
    Simulation built = blockWith("neo-hookean", c.numerics), copy = blockWith(c.name, c.numerics);
    built.runSteps(30), copy.runSteps(30);
    EXPECT_EQ(wholeStateOf(built), wholeStateOf(copy)) << c.name;
    EXPECT_EQ(built.ledger().now.elastic, copy.ledger().now.elastic) << c.name;
  }
}

/// Two blocks that touch, one with the law and one with another.
std::string blocksWith(const std::string& law, const std::string& other, const std::string& numerics) {
  return std::string(block) + "law = \"" + law + R"("
[material.wax]
density = 900
young = "200 kPa"
law = ")" +
         other + R"("
[[body]]
name = "top"
box = { size = [0.4, 0.3, 0.3] }
material = "wax"
place = { move = [0, 0, 0.3] }
)" + numerics;
}

TEST(ExtensionLaws, HaveTheBitsOfTheBuiltInInGroupsWithOtherLaws) {
  for (const LawCopy& c : lawCopies)
    for (const char* other : {"neo-hookean", "corotated"}) {
      Simulation built = simulationOf(blocksWith("neo-hookean", other, c.numerics), MPI_COMM_SELF),
                 copy = simulationOf(blocksWith(c.name, other, c.numerics), MPI_COMM_SELF);
      built.runSteps(30), copy.runSteps(30);
      EXPECT_EQ(wholeStateOf(built), wholeStateOf(copy)) << c.name << " and " << other;
      EXPECT_EQ(built.ledger().now.elastic, copy.ledger().now.elastic) << c.name << " and " << other;
    }
}

TEST(ExtensionLaws, HaveTheSameBitsOnAnyNumberOfRanks) {
  for (const LawCopy& c : lawCopies)
    for (const std::string& text : {std::string(block) + "law = \"" + c.name + "\"\n" + c.numerics,
                                    blocksWith(c.name, "green", c.numerics)}) {
      Simulation sim = simulationOf(text), alone = simulationOf(text, MPI_COMM_SELF);
      sim.runSteps(30);
      alone.runSteps(30);
      expectSameBits(sim, alone);
    }
}

TEST(ExtensionLaws, StressIsTheDerivativeOfTheEnergy) {
  const Simulation sim = blockWith("copy");
  const BoundLaw& law = boundLaw(sim.scene().materials[0]);
  Mat3d g{};
  g.row[0] = {0.2, 0.1, -0.3}, g.row[1] = {0.03, -0.15, 0.2}, g.row[2] = {-0.1, 0.4, 0.1};
  const Mat3d stress = responseOf(law, g, 2e5, 1e5).stress;
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) {
      Mat3d low = g, high = g;
      low.row[r][c] -= 1e-5, high.row[r][c] += 1e-5;
      const double slope = (responseOf(law, high, 2e5, 1e5).energy - responseOf(law, low, 2e5, 1e5).energy) /
                           2e-5;
      EXPECT_NEAR(slope, stress.row[r][c], 1e-3);
    }
  ElasticConstants c;
  c.lambda = 2e5, c.mu = 1e5, c.law = &boundLaw(ExtensionSettings{.name = "neo-hookean", .values = {}});
  const Vec3d stretch{1.2, 0.9, 1.1}, built = principalKirchhoff(c, stretch),
                                      ours = principalOf(law, stretch, 2e5, 1e5);
  EXPECT_LT(length(built - ours), 1e-9 * length(built));
}

TEST(ExtensionLaws, AreRefusedWithTheirPlace) {
  EXPECT_NE(messageOf(std::string(block) + "law = \"copyy\"\n").find("\"copy\""), std::string::npos);
  EXPECT_NE(
      messageOf(std::string(block) + "law = \"copy\"\ncopy = { used = 1 }\n").find("unknown key 'used'"),
      std::string::npos);
  EXPECT_NE(
      messageOf(std::string(block) + "law = \"green\"\ncopy = { unused = 1 }\n").find("unknown key 'copy'"),
      std::string::npos);
}

TEST(ExtensionShapes, CopyOfASphereEqualsTheBuiltIn) {
  const auto scene = [](const char* body, const char* obstacle) {
    return std::string(R"(
spacing = 0.05
end = 1
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.jelly]
density = 1000
young = "100 kPa"
[[body]]
name = "top"
material = "jelly"
place = { move = [0, 0, 0.52] }
)") + body +
           "[[obstacle]]\nname = \"bottom\"\n" + obstacle;
  };
  Simulation built = simulationOf(scene("sphere = { radius = 0.2 }\n", "sphere = { radius = 0.3 }\n")),
             copy = simulationOf(scene("ball = { size = \"20 cm\" }\n", "ball = { size = 0.3 }\n"));
  built.runUntil(0.1);
  copy.runUntil(0.1);
  EXPECT_EQ(wholeStateOf(built), wholeStateOf(copy));
  EXPECT_GT(built.ledger().now.elastic, 0);
}

TEST(ExtensionShapes, AreRefusedWithTheirPlace) {
  const std::string start = std::string(block) + "[[obstacle]]\nname = \"it\"\n";
  EXPECT_NE(messageOf(start + "ball = { radius = 1 }\n").find("unknown key 'radius'"), std::string::npos);
  EXPECT_NE(messageOf(start + "bal = { size = 1 }\n").find("did you mean 'ball'"), std::string::npos);
  EXPECT_NE(messageOf(start + "ball = { size = 0.1 }\nsphere = { radius = 1 }\n").find("a second shape"),
            std::string::npos);
  EXPECT_NE(messageOf(start + "ball = { size = -1 }\n").find("ball.size"), std::string::npos);
}

TEST(Extensions, OfASceneAreListedOnce) {
  const std::string text = blocksWith("copy", "copy",
                                      "[extension.shade]\n[[obstacle]]\nname = \"lid\"\n"
                                      "ball = { size = 0.1 }\nplace = { move = [0, 0, 0.9] }\n");
  const Simulation sim = simulationOf(text, MPI_COMM_SELF);
  Scene scene = sim.scene();
  std::vector<std::string> names;
  for (const Extension* e : usedExtensions(scene)) names.push_back(e->name);
  EXPECT_EQ(names, (std::vector<std::string>{"shade", "copy", "ball"}));
  EXPECT_EQ(std::count(sim.world().modules.why.begin(), sim.world().modules.why.end(),
                       "extension 'copy': " + findExtension("copy")->about),
            1);
}

TEST(Hooks, RunAfterEachPhase) {
  Simulation sim = simulationOf(drop);
  std::string order;
  for (std::size_t k = 0; k < hookPhaseNames.size(); k++)
    sim.onPhase(static_cast<HookPhase>(k), [&order, k] { order += std::to_string(k); });
  EXPECT_THROW(sim.onPhase(static_cast<HookPhase>(7), [] {}), std::out_of_range);
  sim.runSteps(2);
  EXPECT_EQ(order, "01234560123456");
}

TEST(Hooks, MayNotChangeVelocities) {
  Simulation sim = simulationOf(drop, MPI_COMM_SELF);
  sim.onPhase(HookPhase::Forces, [&] { sim.beginEdit(); });
  EXPECT_THROW(sim.step(), std::logic_error);
}

TEST(Extensions, WithoutPartsOrWithTakenNamesAreRefused) {
  registerAll();
  EXPECT_THROW(registerExtension({.name = "empty"}), std::invalid_argument);
  const auto withField = [](const char* name) {
    return Extension{.name = "fields", .fields = {{name, "1", ""}}};
  };
  for (const char* name : {"velocity", "density", "age", "two words", ""})
    EXPECT_THROW(registerExtension(withField(name)), std::invalid_argument) << name;
  Extension shape = test::copyOfBall();
  shape.name = "torus";
  EXPECT_THROW(registerExtension(shape), std::invalid_argument);
  Extension many = test::copyOfNeoHookean();
  many.name = "many";
  for (int k = 0; k < 9; k++) many.keys.push_back({"key" + std::to_string(k), "", 0});
  EXPECT_THROW(registerExtension(many), std::invalid_argument);
  EXPECT_EQ(findExtension("many"), nullptr);
}

}  // namespace
}  // namespace thaw
