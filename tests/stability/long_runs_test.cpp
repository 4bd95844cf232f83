// SPDX-License-Identifier: Apache-2.0
// Elastic bodies over 5e4 steps and more, which reveal slow growth: row 10 of docs/validation/stability.md.
#include <cmath>
#include <functional>

#include "core/scene/quality.hpp"
#include "core/time/frame_times.hpp"
#include "tests/support/measured.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.1;
constexpr Vec3i size{8, 6, 4};

/// A small block in free flight that spins and oscillates. Frames every 40 ms, the default of a scene.
Scene freeBlock(Quality quality, const char* law) {
  Scene s;
  s.spacing = dx;
  s.end = 1e9;
  s.domain.min = {-3, -3, -3};
  s.domain.max = {3, 3, 3};
  s.domain.gravity = {};
  s.output.every = 0.04;
  applyQuality(quality, s.numerics);
  s.materials.emplace_back();
  s.materials[0].young = {1e6, 0};
  s.materials[0].poisson = {0.3, 0.3};
  s.materials[0].law.name = law;
  const Vec3d half = 0.5 * dx * Vec3d{double(size.x), double(size.y), double(size.z)};
  addBox(s, -half, half);
  return s;
}

void launch(Simulation& run) {
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d x = p.position[i];
    p.velocity[i] = cross(Vec3d{0.5, 2, 1}, x) +
                    Vec3d{0.3 * std::sin(3 * x.x), 0.6 * x.x * x.x - 0.03, 0.4 * x.y};
  }
  initializeForces(run.w, run.halos(), run.tools);
}

double residual(Simulation& run) {
  const LedgerReport l = run.ledgerReport();
  return std::abs(l.energyResidual) / (l.initial.kinetic + l.initial.elastic);
}

/// Largest residual over `steps` steps relative to the initial energy; stops when it exceeds 1. Counts frames
/// as in a run that writes them.
double largestResidual(Simulation& run, int steps, const std::function<double()>& naiveStep = {}) {
  Clock& c = run.w.clock;
  double most = 0;
  for (int n = 0; n < steps && most < 1; n++) {
    if (naiveStep) c.stepDt = 0, c.dt = naiveStep();
    if (!run.step()) return never;
    while (frameDue(c)) c.frame++;
    if (n % 20 == 0) most = std::max(most, residual(run));
  }
  return std::max(most, residual(run));
}

}  // namespace

TEST(Stability, Row10LongElasticRuns) {
  for (const Quality quality : {Quality::Standard, Quality::Preview, Quality::Reference})
    for (const char* const law : {"green", "neo-hookean"}) {
      if (quality == Quality::Reference && std::string_view(law) != "green") continue;
      Simulation run(freeBlock(quality, law));
      launch(run);
      const double most = largestResidual(run, 50000);
      measured("%s, %s: at most %.1e of the energy unexplained in 50000 steps, %.0f s",
               quality == Quality::Standard  ? "standard"
               : quality == Quality::Preview ? "preview"
                                             : "reference",
               law, most, run.w.clock.time);
      EXPECT_LT(most, 1e-3);
    }
}

// Naive steps have the length of the limit. The last two before each frame are shortened to end at the frame,
// by a different amount in every frame.
TEST(Stability, Row10StepsCutAtFrames) {
  double most[2];
  for (const bool naive : {true, false}) {
    Scene s = freeBlock(Quality::Preview, "neo-hookean");
    const double every = s.output.every;
    if (naive) s.output.every = 0;  // this test hits the frames itself
    Simulation run(s);
    launch(run);
    const double limit = run.w.clock.dt;
    const auto step = [&] {
      const double left = every * (std::floor(run.w.clock.time / every * (1 + 1e-12) + 1e-9) + 1) -
                          run.w.clock.time;
      return left < 2 * limit ? (left <= limit * (1 + 1e-9) ? left : 0.5 * left) : limit;
    };
    most[naive] = naive ? largestResidual(run, 30000, step) : largestResidual(run, 30000);
  }
  measured(
      "%.1e of the energy unexplained with the last two steps of each frame cut, %.1e with all steps equal",
      most[1], most[0]);
  EXPECT_GT(most[1], 0.1);
  EXPECT_LT(most[0], 1e-3);
}

// Far from the stability limit the energy of leap-frog oscillates with the square of the step, and nothing
// grows.
TEST(Stability, Row10ElasticStepsBeyondTheLimit) {
  for (const double over : {1.0, 1.25, 1.5, 2.0}) {
    Scene s = freeBlock(Quality::Standard, "neo-hookean");
    s.output.every = 0;
    s.numerics.cflElastic *= over;
    Simulation run(s);
    launch(run);
    const double most = largestResidual(run, 20000);
    measured("elastic steps %.2f times the default: at most %.1e of the energy unexplained in 20000 steps",
             over, most);
    EXPECT_LT(most, 1e-3 * over * over);
  }
}

}  // namespace thaw::test
