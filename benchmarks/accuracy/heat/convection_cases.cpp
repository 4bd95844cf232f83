// SPDX-License-Identifier: Apache-2.0
// Free convection against a benchmark solution (docs/validation/accuracy.md).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

/// A line of references/cavity.csv (DVD83).
struct BenchMark {
  double rayleigh = 0, nusselt = 0, along = 0, rise = 0;
};

BenchMark benchMarkAt(double rayleigh) {
  const std::string path = std::string(THAW_BENCHMARK_FOLDER) + "/references/cavity.csv";
  FILE* in = std::fopen(path.c_str(), "r");
  if (!in) throw std::runtime_error(path + ": cannot be read");
  BenchMark nearest;
  char line[400];
  while (std::fgets(line, sizeof line, in)) {
    BenchMark b;
    if (std::sscanf(line, "%lf,%lf,%lf,%lf", &b.rayleigh, &b.nusselt, &b.along, &b.rise) != 4) continue;
    const auto away = [&](const BenchMark& x) { return std::abs(std::log(x.rayleigh / rayleigh)); };
    if (nearest.rayleigh == 0 || away(b) < away(nearest)) nearest = b;
  }
  std::fclose(in);
  return nearest;
}

/// A square cavity of edge H between a hot wall at low x and a cold one at high x.
struct Cavity {
  double edge, difference, middle, diffusivity, viscosity, speed;
  explicit Cavity(const Scene& s) {
    const Material& m = s.materials[0];
    const double hot = *s.obstacles[0].temperature, cold = *s.obstacles[1].temperature;
    edge = s.domain.max.x - s.domain.min.x;
    difference = hot - cold;
    middle = 0.5 * (hot + cold);
    diffusivity = m.conductivity.liquid / (m.density * m.heatCapacity.liquid);
    viscosity = m.viscosity.liquid / m.density;
    speed = std::sqrt(length(s.domain.gravity + s.domain.buoyantGravity) * m.expansion * difference * edge);
  }
  double rayleigh() const { return speed * speed * edge * edge / (viscosity * diffusivity); }
};

/// Records the mean Nusselt number: 1 + <u (T - Tm)> H / (a dT), the mean over x of that of vertical lines.
void watchNusselt(Trial& r) {
  constexpr std::int64_t every = 20;  // steps
  if (r.world.clock.step % every != 0) return;
  const Cavity c(r.world.scene);
  const double carried = sum(r, [&](const World& w, std::size_t i) {
    return w.particles.mass[i] * w.particles.velocity[i].x * (w.particles.temperature[i] - c.middle);
  });
  r.series.push_back(
      {r.world.clock.time, {1 + carried / r.tools.mass * c.edge / (c.diffusivity * c.difference)}});
}

/// Mean of the record from `from` to `to`, as fractions of its time.
double meanBetween(const Trial& r, double from, double to) {
  double total = 0, count = 0;
  for (const Sample& s : r.series) {
    const double at = s.time / r.world.clock.time;
    if (at < from || at > to) continue;
    total += s.value[0];
    count++;
  }
  return total / count;
}

/// Fastest mean flow along axis `along` in cells of one spacing on the middle line along axis `across`, over
/// diffusivity / edge.
double fastestOnMiddleLine(Trial& r, int along, int across) {
  const Scene& s = r.world.scene;
  const Cavity c(s);
  const int cells = static_cast<int>(std::lround(c.edge / s.spacing));
  double fastest = 0;
  for (int k = 0; k < cells; k++) {
    const auto here = [&](const World& w, std::size_t i) {
      const Vec3d x = w.particles.position[i] - s.domain.min;
      return std::abs(x[along] - 0.5 * c.edge) < s.spacing &&
             static_cast<int>(x[across] / c.edge * cells) == k;
    };
    const double count = sum(r, [&](const World& w, std::size_t i) { return here(w, i) ? 1.0 : 0.0; });
    const double flow = sum(
        r, [&](const World& w, std::size_t i) { return here(w, i) ? w.particles.velocity[i][along] : 0.0; });
    if (count > 0) fastest = std::max(fastest, std::abs(flow / count));
  }
  return fastest * c.edge / c.diffusivity;
}

std::vector<Figure> measureCavity(Trial& r) {
  const Cavity c(r.world.scene);
  const BenchMark exact = benchMarkAt(c.rayleigh());
  const double nusselt = meanBetween(r, 0.75, 1), before = meanBetween(r, 0.5, 0.75);
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  const double capacity = r.world.scene.materials[0].heatCapacity.liquid;
  return {
      {"mean Nusselt number", std::abs(nusselt / exact.nusselt - 1), c.rayleigh() < 3e4 ? 0.02 : 0.05},
      {"mean Nusselt number / exact", nusselt / exact.nusselt},
      {"its change in a quarter", std::abs(nusselt / before - 1)},
      {"fastest rise", std::abs(fastestOnMiddleLine(r, 2, 0) / exact.rise - 1)},
      {"fastest flow along x", std::abs(fastestOnMiddleLine(r, 0, 2) / exact.along - 1)},
      {"energy residual", std::abs(ledger.energyResidual) / std::abs(ledger.wallWork), 0.01},
      {"momentum residual", length(ledger.momentumResidual) / (ledger.now.mass * c.speed), 1e-9},
      {"heat residual", std::abs(ledger.heatResidual) / (c.difference * ledger.now.mass * capacity), 1e-12}};
}

/// Viscosity and conductivity for a Rayleigh number of 1e5 at the same speed. The flow needs longer to become
/// steady.
void makeFaster(Scene& s) {
  makeThin(s);
  s.end = 40;
  Material& m = s.materials[0];
  for (double* x : {&m.viscosity.solid, &m.viscosity.liquid, &m.conductivity.solid, &m.conductivity.liquid})
    *x /= std::sqrt(10.0);
}

}  // namespace

std::vector<Case> convectionCases() {
  return {{.name = "cavity",
           .about = "free convection in a square cavity, Ra = 1e4, against de Vahl Davis 1983",
           .watch = watchNusselt,
           .measure = measureCavity,
           .adapt = makeThin},
          {.name = "cavity_1e5",
           .about = "free convection in a square cavity, Ra = 1e5, against de Vahl Davis 1983",
           .scene = "cavity",
           .watch = watchNusselt,
           .measure = measureCavity,
           .adapt = makeFaster}};
}

}  // namespace thaw::accuracy
