#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "benchmarks/sheet/tests.hpp"
#include "io/scene/read_scene.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::bench {
namespace {

/// Frames of 1/25 s a second, without output, in about `budget` s.
double framesPerSecond(const std::string& scene, double spacing, double budget, std::size_t& vertices, double& stepsPerFrame) {
  using Clock = std::chrono::steady_clock;
  Scene s = readScene(std::string(THAW_BENCHMARK_FOLDER) + "/../../scenes/sheet/" + scene + ".toml", {});
  s.sheets[0].spacing = spacing;
  s.sheets[0].selfContact = false;  // nothing says that the paper's membrane had any
  s.spacing = 0.5 * spacing;
  s.output.every = 0.04;
  test::Simulation sim(s);
  vertices = sim.w.sheets.rows.owned;
  const auto start = Clock::now();
  double seconds = 0;
  const double begin = sim.w.clock.time;
  while (seconds < budget && sim.w.clock.time < sim.w.clock.end) {
    sim.step();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  const double frames = (sim.w.clock.time - begin) / 0.04;
  stepsPerFrame = static_cast<double>(sim.w.clock.step) / frames;
  return frames / seconds;
}

}  // namespace

void frames(std::size_t large, const Out& out) {
  // The paper gives no numbers of vertices. 2500 for a head of polygons and 1500 for the membrane are what its pictures may have had.
  struct Case { const char *scene, *paper; double vertices, perSpacing; };  // vertices * spacing^2
  const Case cases[] = {{"head", "3 (SGI Indigo-2)", 2500, 7842 * 0.004 * 0.004}, {"jack", "1.5 to 2.4 (SGI Indigo-2)", 1500, 14442 * 0.005 * 0.005}};
  std::printf("\n%-6s %10s %14s %12s   %s\n", "scene", "vertices", "frames/s", "steps/frame", "the paper's frames/s");
  for (const Case& c : cases)
    for (const double n : {c.vertices, static_cast<double>(large)}) {
      std::size_t vertices = 0;
      double steps = 0;
      const double rate = framesPerSecond(c.scene, std::sqrt(c.perSpacing / n), n > 1e5 ? 30 : 6, vertices, steps);
      std::printf("%-6s %10zu %14.3f %12.1f   %s\n", c.scene, vertices, rate, steps, n == c.vertices ? c.paper : "");
      out.line("frames", c.scene, "exact", static_cast<std::int64_t>(steps), static_cast<double>(vertices), 0, rate, "frames/s");
    }
}

}  // namespace thaw::bench
