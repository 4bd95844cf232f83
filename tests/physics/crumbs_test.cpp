// Crumbs on a puddle: a particle or a few that come to lie on hot liquid of their kind sink in and take its
// temperature by conduction.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.0041, hot = 500;

/// A puddle of the wax of scenes/melt.toml, four spacings deep, all of it at 500 K, nothing heated from
/// outside; and a cube of it of `size` spacings, 2.4 spacings above its particles.
Scene puddleWithCrumb(double temperature, int size) {
  Scene s = columnScene(dx, 0, 20 * dx);
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.materials[0] = wax();
  s.materials[0].surfaceTension = 0.03;
  s.materials[0].soundSpeed = 26;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 4 * dx}).temperature = hot;
  const double low = 5.4 * dx, half = 0.5 * size * dx;
  addBox(s, {3 * dx - half, 3 * dx - half, low}, {3 * dx + half, 3 * dx + half, low + 2 * half}).temperature =
      temperature;
  s.end = 1;
  return s;
}

struct Crumb {
  double temperature = 0, nearest = never;
};

/// Mean temperature of the second body (K), and its distance from the first (dx).
Crumb crumbOf(const Continuum& p) {
  Crumb c;
  double count = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.body[i] != 1) continue;
    count++;
    c.temperature += p.temperature[i];
    for (std::size_t j = 0; j < p.owned; j++)
      if (p.body[j] == 0) c.nearest = std::min(c.nearest, length(p.position[i] - p.position[j]) / dx);
  }
  c.temperature /= count;
  return c;
}

// s, s, dx at the end, share
struct Warming {
  double touched = never, warm = never, nearest = never, heatLost = never;
};

/// When it has come within 1.5 spacings, and when it has lost .9 of its cold.
Warming warmingOf(double temperature, int size) {
  Simulation run(puddleWithCrumb(temperature, size));
  Warming at;
  while (run.w.clock.time < run.w.scene.end) {
    if (!run.step()) return {};
    const double t = run.w.clock.time;
    const Crumb c = crumbOf(run.particles());
    if (c.nearest < 1.5) at.touched = std::min(at.touched, t);
    if (c.temperature > temperature + 0.9 * (hot - temperature)) at.warm = std::min(at.warm, t);
    at.nearest = c.nearest;
  }
  double heat = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++)
    heat += run.particles().mass[i] * run.particles().enthalpy[i];
  at.heatLost = std::abs(run.books().heatResidual) / heat;
  return at;
}

/// dx^2 / alpha, s: .1.
double diffusionTime() {
  const Material m = wax();
  return dx * dx * m.density * m.heatCapacity.liquid / m.conductivity.liquid;
}

}  // namespace

// A cube of edge a warms through its lower face: by its own resistance (a slab loses .9 in .85 a^2/alpha) and
// that of the half-space around a spot of its area (a capacity a^3 over 4 k r, r = a / sqrt(pi): 2.3 times
// .44 a^2/alpha): some 1.9 a^2/alpha for .9 of it; measured 2.7 of a single particle, which four touch,
// and 1.3 to 1.5 of eight, which sink in. While one of 340 K hung above the puddle it got there in no time
// that was waited for.
TEST(Crumbs, WarmByConduction) {
  for (const double temperature : {300.0, 340.0})  // solid; just molten
    for (const int size : {1, 2}) {
      const Warming at = warmingOf(temperature, size);
      EXPECT_LT(at.touched, 0.15) << temperature << " " << size;
      EXPECT_LT(at.warm - at.touched, (size == 1 ? 3.0 : 1.6) * size * size * diffusionTime())
          << temperature << " " << size;
      EXPECT_LT(at.nearest, 1) << temperature << " " << size;  // as near as neighbours in a liquid: it is
                                                               // part of the puddle
      EXPECT_LT(at.heatLost, 1e-12) << temperature << " " << size;
    }
}

}  // namespace thaw::test
