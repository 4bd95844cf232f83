// SPDX-License-Identifier: Apache-2.0
// Extreme times, leaving particles, non-finite values: rows of docs/validation/stability.md.
#include <cstring>

#include "core/heat/heat.hpp"
#include "io/scene/read_scene.hpp"
#include "tests/support/hashed.hpp"
#include "tests/support/measured.hpp"
#include "tests/support/periodic_block.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;

}  // namespace

TEST(Stability, Row26StrangeTimes) {
  // a step of 0 changes nothing
  Scene s = periodicBlock();
  s.materials[0].soundSpeed = 10;
  s.materials[0].viscosity = {1, 1};
  s.end = 1;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    p.velocity[i] = {hashed(p.id[i]) - 0.5, hashed(7 * p.id[i]) - 0.5, 0};
  for (int n = 0; n < 5; n++) EXPECT_TRUE(run.step());
  const std::vector<Vec3d> x(p.position.data(), p.position.data() + p.owned),
      v(p.velocity.data(), p.velocity.data() + p.owned);
  const double time = run.w.clock.time;
  run.w.clock.dt = 0;
  EXPECT_TRUE(run.step());
  EXPECT_EQ(std::memcmp(x.data(), p.position.data(), x.size() * sizeof(Vec3d)), 0);
  EXPECT_EQ(std::memcmp(v.data(), p.velocity.data(), v.size() * sizeof(Vec3d)), 0);
  EXPECT_EQ(run.w.clock.time, time);
  // other invalid lengths are refused when the scene is read, in one message
  const std::string good =
      "end = 1\n[material.m]\n[[body]]\nbox = { size = [0.1, 0.1, 0.1] }\nmaterial = \"m\"\n";
  int refused = 0;
  for (const char* bad :
       {"numerics.fixed_step=-0.1", "numerics.fixed_step=1e6", "numerics.max_step=0", "numerics.max_step=-1",
        "end=-1", "output.every=0", "output.every=-1", "output.every=1e-12"}) {
    try {
      readScene(sceneFilesOf("s.toml", good), {bad});
      ADD_FAILURE() << bad;
    } catch (const SceneErrors& e) {
      EXPECT_EQ(e.lines.size(), 1u) << bad;
      refused++;
    }
  }
  measured("a step of 0 changes no bit; %d of 8 strange times refused", refused);
}

TEST(Stability, Row27ParticlesThatLeave) {
  // A burst in all directions with half of the sides open: leaving particles are counted and recorded, the
  // others stay inside walls.
  Scene s;
  s.spacing = dx;
  s.domain.min = {-6 * dx, -6 * dx, -6 * dx};
  s.domain.max = {6 * dx, 6 * dx, 6 * dx};
  s.domain.side[0] = s.domain.side[1] = {Side::Open, Side::Wall};
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {};
  s.output.every = 0;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 20;
  s.materials[0].viscosity = {0.1, 0.1};
  addBox(s, {-3 * dx, -3 * dx, -3 * dx}, {3 * dx, 3 * dx, 3 * dx});
  s.end = 0.2;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = 100.0 * p.position[i];
  run.w.ledger.initial = run.ledgerReport().now;
  EXPECT_TRUE(run.run());
  double beyond = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    for (int a = 0; a < 3; a++)
      beyond = std::max({beyond, p.position[i][a] - 6 * dx, -6 * dx - p.position[i][a]});
  const LedgerReport r = run.ledgerReport();
  const double m = 1000 * dx * dx * dx;
  measured(
      "%lld of 216 particles left; mass residual %.1e kg, momentum residual %.1e of what left; furthest "
      "beyond a wall %.1e spacings",
      static_cast<long long>(run.w.counters.left), r.massResidual,
      length(r.momentumResidual) / length(r.left.momentum), beyond / dx);
  EXPECT_GT(run.w.counters.left, 50);
  EXPECT_LE(std::abs(r.massResidual), 1e-15 * r.initial.mass);  // exact sums, up to rounding in the report
  EXPECT_NEAR(r.left.mass, static_cast<double>(run.w.counters.left) * m, 1e-12);
  std::int64_t through = 0;
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++) {
      through += run.w.counters.leftThrough[a][high];
      EXPECT_EQ(run.w.counters.leftThrough[a][high] > 0,
                s.domain.side[static_cast<std::size_t>(a)][static_cast<std::size_t>(high)] == Side::Open)
          << a << high;
    }
  EXPECT_EQ(through, run.w.counters.left);
  EXPECT_EQ(static_cast<std::int64_t>(p.owned) + run.w.counters.left, 216);
  EXPECT_LE(beyond, 0);
  EXPECT_LT(length(r.momentumResidual), 1e-5 * length(r.left.momentum));
}

TEST(Stability, Row28NumbersThatSpread) {
  // during a run: one NaN is detected in its step, with the particle named
  const double nan = std::nan(""), inf = never;
  int seen = 0;
  for (const double bad : {nan, inf, -inf, 1e300}) {
    for (const bool place : {false, true}) {
      Scene s = periodicBlock();
      s.materials[0].soundSpeed = 10;
      s.domain.side = {};
      s.domain.min = {-1, -1, -1};
      s.domain.max = {1, 1, 1};
      s.end = 1;
      Simulation run(s);
      EXPECT_TRUE(run.step());
      if (place) run.particles().acceleration[77].y = bad;
      else run.particles().velocity[77].y = bad;
      const std::uint64_t id = run.particles().id[77];
      const StepOutcome o = step(run.w, run.halos(), run.tools, {});
      const bool left = run.w.counters.left > 0;  // fast enough to leave through an open side
      if (!o.finite) { EXPECT_EQ(run.particles().id[o.bad], id); }
      EXPECT_TRUE(!o.finite || left) << bad;
      seen += !o.finite || left;
    }
  }
  // in a scene: refused with file, line and column
  const std::string good =
      "spacing = 0.02\n[material.m]\nyoung = 1e5\n[[body]]\nbox = { size = [0.1, 0.1, 0.1] }\nmaterial = "
      "\"m\"\n";
  const std::pair<const char*, const char*> mistakes[] = {{"spacing = 0.02", "spacing = nan"},
                                                          {"spacing = 0.02", "spacing = 0"},
                                                          {"spacing = 0.02", "spacing = -1"},
                                                          {"young = 1e5", "young = inf"},
                                                          {"young = 1e5", "young = 1e5\npoisson = 0.5"},
                                                          {"young = 1e5", "young = 1e5\ndensity = 0"},
                                                          {"young = 1e5", "young = 1e5\ndensity = -1"},
                                                          {"young = 1e5", "young = 1e5\nviscosity = nan"},
                                                          {"[0.1, 0.1, 0.1]", "[0.1, 0.1, inf]"},
                                                          {"[0.1, 0.1, 0.1]", "[0.1, 0.1, -0.1]"}};
  int refused = 0;
  for (const auto& [what, by] : mistakes) {
    std::string text = good;
    text.replace(text.find(what), std::strlen(what), by);
    try {
      readScene(sceneFilesOf("s.toml", text));
      ADD_FAILURE() << by;
    } catch (const SceneErrors& e) {
      ASSERT_EQ(e.lines.size(), 1u) << by;
      EXPECT_EQ(e.lines[0].rfind("s.toml:", 0), 0u) << e.lines[0];
      EXPECT_NE(e.lines[0].find(": error: "), std::string::npos) << e.lines[0];
      refused++;
    }
  }
  measured(
      "%d of 8 bad numbers of a running simulation found in their step, the particle named; %d of 10 in a "
      "scene refused with line and column",
      seen, refused);
}

}  // namespace thaw::test
