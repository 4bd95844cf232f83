// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "benchmarks/sheet/tests.hpp"
#include "io/scene/read_scene.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::bench {
namespace {

struct Frames {
  std::size_t vertices = 0;
  double perSecond = 0, steps = 0;                       ///< frames per second; steps per frame
  double motion = 0, forces = 0, contact = 0, rest = 0;  ///< ns per vertex and step
};

/// Rate of frames of 1/25 s without output, measured for about `budget` s.
Frames framesPerSecond(const std::string& scene, double spacing, double budget) {
  using Clock = std::chrono::steady_clock;
  Scene s = readScene(std::string(THAW_BENCHMARK_FOLDER) + "/../../scenes/sheet/" + scene + ".toml", {});
  s.sheets[0].spacing = spacing;
  s.sheets[0].selfContact = false;  // the paper does not state self-contact for the membrane
  s.spacing = 0.5 * spacing;
  s.output.every = 0.04;
  test::Simulation sim(s);
  Frames f;
  f.vertices = sim.w.sheets.rows.owned;
  sim.tools.times = {};
  const auto start = Clock::now();
  double seconds = 0;
  const double begin = sim.w.clock.time;
  while (seconds < budget && sim.w.clock.time < sim.w.clock.end) {
    sim.step();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  const double frames = (sim.w.clock.time - begin) / 0.04;
  f.steps = static_cast<double>(sim.w.clock.step) / frames;
  f.perSecond = frames / seconds;
  const PhaseTimes& t = sim.tools.times;
  const double each = 1e9 / (static_cast<double>(f.vertices) * static_cast<double>(sim.w.clock.step));
  f.motion = t[StepPhase::SheetMotion] * each;
  f.forces = t[StepPhase::Sheet] * each;
  f.contact = t[StepPhase::SheetContact] * each;
  f.rest = seconds * each - f.motion - f.forces - f.contact;
  return f;
}

}  // namespace

void frames(std::size_t large, const Out& out) {
  // The paper gives no numbers of vertices. 2500 for the polygonal head and 1500 for the membrane are
  // estimates from its pictures. Fields: vertices * spacing^2; target: twice the paper's frames.
  struct Case {
    const char *scene, *paper;
    double target, vertices, perSpacing;
  };
  const Case cases[] = {{"head", "3 (SGI Indigo-2)", 6, 2500, 7842 * 0.004 * 0.004},
                        {"jack", "1.5 to 2.4 (SGI Indigo-2)", 4.8, 1500, 14442 * 0.005 * 0.005}};
  std::printf("\n%-6s %10s %10s %8s %12s   %-44s  %s\n", "scene", "vertices", "frames/s", "target",
              "steps/frame", "ns per vertex and step: motion, forces, contact, rest", "the paper's frames/s");
  for (const Case& c : cases)
    for (const double n : {c.vertices, static_cast<double>(large)}) {
      const bool small = n == c.vertices;
      const Frames f = framesPerSecond(c.scene, std::sqrt(c.perSpacing / n), n > 1e5 ? 30 : 6);
      char target[8] = "-";
      if (small) std::snprintf(target, sizeof target, "%.1f", c.target);
      std::printf("%-6s %10zu %10.3f %8s %12.1f   %11.1f %11.1f %11.1f %11.1f      %s\n", c.scene, f.vertices,
                  f.perSecond, target, f.steps, f.motion, f.forces, f.contact, f.rest, small ? c.paper : "");
      out.line("frames", c.scene, "exact", static_cast<std::int64_t>(f.steps),
               static_cast<double>(f.vertices), 0, f.perSecond, "frames/s");
      for (const auto& [phase, ns] :
           {std::pair{"motion", f.motion}, {"forces", f.forces}, {"contact", f.contact}, {"rest", f.rest}})
        out.line("phases", c.scene, phase, static_cast<std::int64_t>(f.steps),
                 static_cast<double>(f.vertices), 0, ns, "ns");
    }
}

}  // namespace thaw::bench
