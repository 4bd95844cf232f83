// SPDX-License-Identifier: Apache-2.0
// Water at rest in tanks that are no multiple of the spacing. One case runs many tanks.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "benchmarks/accuracy/trial.hpp"
#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw::accuracy {
namespace {

constexpr double settled = 0.75;  // fraction of the run before pressures count

double heightOf(const World& w, std::size_t i) { return w.particles.position[i].z; }

/// Accumulates the sums n, z, p, zz, zp, pp of a linear fit p = a + b z in every step after the liquid has
/// settled.
void watchPressure(Trial& r) {
  const Clock& clock = r.world.clock;
  if (clock.time < settled * clock.end || clock.step % 5 != 0) return;
  const auto p = [&r](const World& w, std::size_t i) {
    return static_cast<double>(pressureOfParticle(w.scene, w.modules, w.particles, r.tools.liquids, i));
  };
  r.notes["n"] += sum(r, [](const World&, std::size_t) { return 1.0; });
  r.notes["z"] += sum(r, heightOf);
  r.notes["p"] += sum(r, p);
  r.notes["zz"] += sum(r, [](const World& w, std::size_t i) { return heightOf(w, i) * heightOf(w, i); });
  r.notes["zp"] += sum(r, [&](const World& w, std::size_t i) { return heightOf(w, i) * p(w, i); });
  r.notes["pp"] += sum(r, [&](const World& w, std::size_t i) { return p(w, i) * p(w, i); });
}

/// Result of one tank, infinite if it blew up. It has errors of the fitted line, scatter over the bottom
/// pressure, residuals, and the fraction of water lost through the open top.
struct Tank {
  double slope = never, value = never, scatter = never, energy = never, momentum = never, lost = 1;
  bool finite = false;
};

/// Exact result: p = g m / A at the bottom, for any level, and a slope of -rho g.
Tank resultOf(Trial& r) {
  if (!r.finite) return {};
  const Scene& s = r.world.scene;
  const Vec3d size = s.domain.max - s.domain.min;
  const double g = length(s.domain.gravity), rho = s.materials[0].density,
               bottom = g * r.tools.mass / (size.x * size.y), depth = bottom / (rho * g);
  const double n = r.notes["n"], z = r.notes["z"] / n, p = r.notes["p"] / n, zz = r.notes["zz"] / n - z * z,
               zp = r.notes["zp"] / n - z * p;
  const double slope = zp / zz, middle = p + slope * (0.5 * depth - z);
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  return {-slope / (rho * g) - 1,
          middle / (0.5 * bottom) - 1,
          std::sqrt(std::max(0.0, r.notes["pp"] / n - p * p - slope * zp)) / bottom,
          std::abs(ledger.energyResidual) / (0.5 * r.tools.mass * g * depth),
          length(ledger.momentumResidual) / (r.tools.mass * std::sqrt(g * depth)),
          1 - ledger.now.mass / r.tools.mass,
          true};
}

/// Tank `tank` of `count`.
Case tankCase(int tank, int count);

void print(const Trial& r, const Tank& t) {
  if (r.comm.rank() != 0) return;
  const double width = r.world.scene.domain.max.x - r.world.scene.domain.min.x;
  std::printf("  tank of %.3f spacings: slope %+.4f, p at half depth %+.4f, scatter %.4f, lost %.4f\n",
              width / r.spacing(), t.slope, t.value, t.scatter, t.lost);
}

/// `first` is the first of `count` tanks; this function runs the others.
std::vector<Figure> measureTanks(Trial& first, int count) {
  std::vector<Tank> all{resultOf(first)};
  print(first, all[0]);
  for (int k = 1; k < count; k++) {
    Trial other(first.comm);
    run(tankCase(k, count), other, first.overrides);
    all.push_back(resultOf(other));
    print(other, all.back());
    first.coreSeconds += other.coreSeconds;
  }
  const auto worst = [&](double Tank::*of) {
    double most = 0;
    for (const Tank& t : all) most = std::max(most, std::abs(t.*of));
    return most;
  };
  const auto misses = std::count_if(all.begin(), all.end(), [](const Tank& t) {
    return !(std::abs(t.slope) <= 0.03 && std::abs(t.value) <= 0.03);
  });
  return {
      {"tanks that blow up",
       static_cast<double>(std::count_if(all.begin(), all.end(), [](const Tank& t) { return !t.finite; })),
       0},
      {"slope of p", worst(&Tank::slope), 0.03},
      {"p at half depth", worst(&Tank::value), 0.03},
      {"largest loss of water", worst(&Tank::lost), 0},
      {"tanks above 3 %", static_cast<double>(misses)},
      {"scatter of p", worst(&Tank::scatter)},
      {"energy residual", worst(&Tank::energy), 0.01},
      {"momentum residual", worst(&Tank::momentum), 1e-9}};
}

/// Spacing (m). Widths in spacings are spread evenly from 2/3 to 4/3 of that at the scene's spacing.
double spacingOf(const Scene& s, int tank, int count) {
  return s.spacing / (2.0 / 3 + 2.0 / 3 * (tank + 0.5) / count);
}

Case tankCase(int tank, int count) {
  return {.name = count == 40 ? "tanks" : "tanks_4",
          .about = count == 40 ? "water at rest in 40 tanks of 15 to 30 spacings, none a whole number of "
                                 "them; hydrostatic pressure"
                               : "the same in 4 tanks",
          .scene = "tanks",
          .watch = watchPressure,
          .measure = [count](Trial& r) { return measureTanks(r, count); },
          .adapt =
              [tank, count](Scene& s) {
                s.spacing = spacingOf(s, tank, count);
                makeThin(s);
              }};
}

}  // namespace

std::vector<Case> tankCases() { return {tankCase(0, 40), tankCase(0, 4)}; }

}  // namespace thaw::accuracy
