// SPDX-License-Identifier: Apache-2.0
// Melting that flow governs (docs/validation/accuracy.md).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

/// A block of wax of length 2a that melts on a plate, with a slab on it. In lubrication theory of a thin film
/// (MWV86), the latent heat gives the thickness d = k dT / (rho L V). The film carries the mean pressure
/// 4 mu V a^2 / d^3.
struct PressedMelt {
  const Scene& s;
  const Material& wax = s.materials[static_cast<std::size_t>(s.bodies[0].material)];
  Vec3d size = s.bodies[0].shape.size;                                               // m
  double warmer = *s.obstacles[0].temperature - 0.5 * (wax.solidus + wax.liquidus);  // K
  double area = size.x * size.y, half = 0.5 * size.x;                                // m^2, m

  double film(double speed) const {
    return wax.conductivity.liquid * warmer / (wax.density * wax.latentHeat * speed);
  }
  double speed(double pressure) const {
    return std::pow(std::pow(film(1), 3) * pressure / (4 * wax.viscosity.liquid * half * half), 0.25);
  }
};

double solidMass(const World& w, std::size_t i) {
  return w.particles.mass[i] * (1 - static_cast<double>(w.particles.liquid[i]));
}

/// Records the mass that has melted, the mass of the solids, and the height of the film (m).
void watchMelt(Trial& r) {
  constexpr std::int64_t every = 50;  // steps
  if (r.world.clock.step % every != 0) return;
  const PressedMelt x{r.world.scene};
  const auto ofBody = [&](std::uint32_t body, auto&& value) {
    return sum(
        r, [&](const World& w, std::size_t i) { return w.particles.body[i] == body ? value(w, i) : 0.0; });
  };
  const double wax = ofBody(0, solidMass), slab = ofBody(1, solidMass),
               height = ofBody(1,
                               [](const World&w, std::size_t i) {
                                 return w.particles.mass[i] * w.particles.position[i].z;
                               }) /
                        slab;
  const double start = x.wax.density * x.area * x.size.z,
               under = height - 0.5 * r.world.scene.bodies[1].shape.size.z - wax / (x.wax.density * x.area);
  r.series.push_back({r.world.clock.time, {start - wax, wax + slab, under}});
}

std::vector<Figure> measureMelt(Trial& r) {
  const Scene& s = r.world.scene;
  const PressedMelt x{s};
  const double end = r.series.back().time;
  std::size_t first = 0;
  while (r.series[first].time < 0.7 * end) first++;
  const Sample &from = r.series[first], &to = r.series.back();
  const double speed = (to.value[0] - from.value[0]) / (x.wax.density * x.area * (to.time - from.time));
  double exact = 0, film = 0;
  const auto count = static_cast<double>(r.series.size() - first);
  for (std::size_t k = first; k < r.series.size(); k++) {
    exact += x.speed(length(s.domain.gravity) * r.series[k].value[1] / x.area) / count;
    film += r.series[k].value[2] / count;
  }
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  return {{"melting speed", std::abs(speed / exact - 1), 0.1},
          {"melting speed / exact", speed / exact},
          {"film thickness", std::abs(film / x.film(exact) - 1), 0.1},
          {"heat residual", std::abs(ledger.heatResidual) / std::abs(ledger.heatIn), 1e-10}};
}

/// Molten fraction of an experiment at a time.
struct Molten {
  double minutes = 0, fraction = 0;
};

std::vector<Molten> moltenGallium() {
  const std::string path = std::string(THAW_BENCHMARK_FOLDER) + "/references/gallium.csv";
  FILE* in = std::fopen(path.c_str(), "r");
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::vector<Molten> all;
  char line[400];
  while (std::fgets(line, sizeof line, in)) {
    Molten m;
    if (std::sscanf(line, "%lf,%lf", &m.minutes, &m.fraction) == 2) all.push_back(m);
  }
  std::fclose(in);
  return all;
}

/// Returns the minutes of the experiment (GV86) per second of the scene. The product of the Fourier and the
/// Stefan number is the same.
double minutesPerSecond(const Scene& s) {
  const Material& m = s.materials[0];
  const auto rate = [](double diffusivity, double stefan, double height) {
    return diffusivity * stefan / (height * height);
  };
  const double melting = 0.5 * (m.solidus + m.liquidus),
               experiment = 60 * rate(32 / (6093 * 381.5), 381.5 * 8.22 / 80160, 0.0635);
  return rate(m.conductivity.liquid / (m.density * m.heatCapacity.liquid),
              m.heatCapacity.liquid * (*s.obstacles[0].temperature - melting) / m.latentHeat,
              s.domain.max.z - s.domain.min.z) /
         experiment;
}

void watchFront(Trial& r) {
  constexpr std::int64_t every = 50;  // steps
  if (r.world.clock.step % every != 0) return;
  const double molten = sum(r, [](const World& w, std::size_t i) {
    return w.particles.mass[i] * static_cast<double>(w.particles.liquid[i]);
  });
  r.series.push_back({r.world.clock.time, {molten / r.tools.mass}});
}

/// Interpolates the molten fraction at a time (s).
double fractionAt(const std::vector<Sample>& series, double time) {
  std::size_t k = 1;
  while (k + 1 < series.size() && series[k].time < time) k++;
  const Sample &a = series[k - 1], &b = series[k];
  return a.value[0] + (b.value[0] - a.value[0]) * (time - a.time) / (b.time - a.time);
}

std::vector<Figure> measureFront(Trial& r) {
  const double scale = minutesPerSecond(r.world.scene), end = r.series.back().time;
  double worst = 0, last = 0;
  for (const Molten& m : moltenGallium()) {
    if (m.minutes > 1.01 * end * scale) continue;
    last = fractionAt(r.series, m.minutes / scale) - m.fraction;
    worst = std::max(worst, std::abs(last));
  }
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  return {{"molten fraction", worst, 0.03},
          {"molten fraction at the end - measured", last},
          {"heat residual", std::abs(ledger.heatResidual) / std::abs(ledger.heatIn), 1e-10}};
}

}  // namespace

std::vector<Case> meltingCases() {
  return {{.name = "contact_melting",
           .about = "block that melts on a warm plate under a load, against Moallemi et al. 1986",
           .watch = watchMelt,
           .measure = measureMelt,
           .adapt = makeThin},
          {.name = "gallium",
           .about = "gallium that melts from the side, against the experiment of Gau and Viskanta 1986",
           .watch = watchFront,
           .measure = measureFront,
           .adapt = makeThin}};
}

}  // namespace thaw::accuracy
