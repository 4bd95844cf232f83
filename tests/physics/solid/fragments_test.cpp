// SPDX-License-Identifier: Apache-2.0
// Fragments on a puddle. One or a few particles that fall on hot liquid of their own material sink in. They
// take its temperature by conduction.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.0041, hot = 500;

/// A puddle of the wax of scenes/melt.toml, four spacings deep, at 500 K, without outside heating. A cube of
/// the same wax of `size` spacings starts 2.4 spacings above its particles.
Scene puddleWithFragment(double temperature, int size) {
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

struct Fragment {
  double temperature = 0, nearest = never;
};

/// Mean temperature (K) of the second body, and its distance (dx) from the first.
Fragment fragmentOf(const Continuum& p) {
  Fragment c;
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

// s, s, dx at the end, unexplained share
struct Warming {
  double touched = never, warm = never, nearest = never, heatLost = never;
};

/// Time until the fragment is within 1.5 spacings, and until 0.9 of its temperature difference is gone.
Warming warmingOf(double temperature, int size) {
  Simulation run(puddleWithFragment(temperature, size));
  Warming at;
  while (run.w.clock.time < run.w.scene.end) {
    if (!run.step()) return {};
    const double t = run.w.clock.time;
    const Fragment c = fragmentOf(run.particles());
    if (c.nearest < 1.5) at.touched = std::min(at.touched, t);
    if (c.temperature > temperature + 0.9 * (hot - temperature)) at.warm = std::min(at.warm, t);
    at.nearest = c.nearest;
  }
  double heat = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++)
    heat += run.particles().mass[i] * run.particles().enthalpy[i];
  at.heatLost = std::abs(run.ledgerReport().heatResidual) / heat;
  return at;
}

/// dx^2 / alpha = 0.1 s.
double diffusionTime() {
  const Material m = wax();
  return dx * dx * m.density * m.heatCapacity.liquid / m.conductivity.liquid;
}

}  // namespace

// A cube of edge a warms through its lower face. The resistances are its own and that of the half-space below
// a spot of its area. They give a time of about 1.9 a^2/alpha for 0.9 of the temperature difference. The cube
// alone takes 0.85 a^2/alpha, like a slab. The half-space adds 2.3 times 0.44 a^2/alpha, for a capacity a^3
// over 4 k r with r = a / sqrt(pi). Measured times are 2.7 a^2/alpha for a single particle, which has four
// contacts. They are 1.3 to 1.6 for eight particles, which sink in against the viscosity of the wax. The
// limits are slightly larger.
TEST(Fragments, WarmByConduction) {
  for (const double temperature : {300.0, 340.0})  // solid; just molten
    for (const int size : {1, 2}) {
      const Warming at = warmingOf(temperature, size);
      EXPECT_LT(at.touched, 0.25) << temperature << " " << size;
      EXPECT_LT(at.warm - at.touched, (size == 1 ? 3.0 : 1.7) * size * size * diffusionTime())
          << temperature << " " << size;
      EXPECT_LT(at.nearest, 1) << temperature << " " << size;  // as close as neighbours in a liquid, hence
                                                               // part of the puddle
      EXPECT_LT(at.heatLost, 1e-12) << temperature << " " << size;
    }
}

}  // namespace thaw::test
