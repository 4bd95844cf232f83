// SPDX-License-Identifier: Apache-2.0
// Liquids with a flow law against exact solutions (docs/validation/accuracy.md): channels, and the slump of a
// cylinder.
#include <algorithm>
#include <cmath>

#include "benchmarks/accuracy/trial.hpp"
#include "core/fluid/flow_laws/flow_law.hpp"

namespace thaw::accuracy {
namespace {

// ---- channels ---------------------------------------------------------------------------------------------

/// Steady flow of a Herschel-Bulkley liquid between walls at a distance H from the middle, driven by a force
/// G per volume. The plug is y0 = tau_y / G thick on either side; outside of it tau_y + K (du/dy)^n = G y.
struct YieldChannel {
  double middle, half, plug, n, speed;
  explicit YieldChannel(const Scene& s) {
    const FlowCoefficients law = flowCoefficients(s.materials[0].flowLaw, 1, 0);
    const double G = s.materials[0].density * s.domain.gravity.x;
    middle = 0.5 * (s.domain.max.z + s.domain.min.z);
    half = 0.5 * (s.domain.max.z - s.domain.min.z);
    plug = law.yieldStress / G;
    n = law.settings->exponent;
    speed = std::pow(G / law.viscosity, 1 / n) * n / (n + 1);
  }
  double fastest() const { return speed * std::pow(half - plug, 1 + 1 / n); }
  double at(double z) const {
    const double y = std::max(std::abs(z - middle) - plug, 0.0);
    return fastest() - speed * std::pow(y, 1 + 1 / n);
  }
  double mean() const {
    const double sheared = half - plug;
    return fastest() * (1 - sheared / half * n / (2 * n + 1));
  }
};

void startYieldChannel(Trial& r) {
  Continuum& p = r.world.particles;
  const YieldChannel exact(r.world.scene);
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i].x = exact.at(p.position[i].z);
}

std::vector<Figure> measureYieldChannel(Trial& r) {
  const YieldChannel exact(r.world.scene);
  const auto u = [](const World& w, std::size_t i) { return w.particles.velocity[i].x; };
  const auto inPlug = [&](const World& w, std::size_t i) {
    return std::abs(w.particles.position[i].z - exact.middle) < exact.plug - w.scene.spacing;
  };
  const double particles = sum(r, [](const World&, std::size_t) { return 1.0; });
  std::vector<Figure> f{
      {"L2(u)",
       rootMeanSquare(r,
                      [&](const World& w, std::size_t i) {
                        return (u(w, i) - exact.at(w.particles.position[i].z)) / exact.fastest();
                      }),
       0.01},
      {"flow rate / exact", sum(r, u) / (particles * exact.mean())},
      {"L2(u across)", rootMeanSquare(r, [&](const World& w, std::size_t i) {
         return std::hypot(w.particles.velocity[i].y, w.particles.velocity[i].z) / exact.fastest();
       })}};
  const double count = sum(r, [&](const World& w, std::size_t i) { return inPlug(w, i) ? 1.0 : 0.0; });
  if (count > 0) {
    const double plug = sum(r, [&](const World& w, std::size_t i) { return inPlug(w, i) ? u(w, i) : 0.0; });
    f.push_back({"speed of the plug", std::abs(plug / count / exact.fastest() - 1)});
  }
  return f;
}

// ---- slump ------------------------------------------------------------------------------------------------

/// Height (m) of the column: of the highest particle within 2 spacings of the axis, plus half a spacing.
double heightOf(Trial& r) {
  return largest(r,
                 [](const World& w, std::size_t i) {
                   const Vec3d& x = w.particles.position[i];
                   return std::hypot(x.x, x.y) < 2 * w.scene.spacing ? x.z : 0.0;
                 }) +
         0.5 * r.spacing();
}

void watchSlump(Trial& r) {
  const double t = r.world.clock.time;
  if (r.series.empty() || t >= 0.9 * r.world.clock.end) r.series.push_back({t, {heightOf(r)}});
}

/// s' = 1 - a tau' (1 - ln a tau'), tau' = tau_y / (rho g H). The yield criterion of Tresca has a = 2
/// (P96), that of von Mises, which the flow laws have, a = sqrt(3).
double slumpBy(double a, double yield) { return 1 - a * yield * (1 - std::log(a * yield)); }

std::vector<Figure> measureLiquidSlump(Trial& r) {
  const Scene& s = r.world.scene;
  const double H = r.series.front().value[0],
               yield = flowCoefficients(s.materials[0].flowLaw, 1, 0).yieldStress /
                       (s.materials[0].density * length(s.domain.gravity) * H);
  const Sample &late = r.series[1], &end = r.series.back();
  const double slump = 1 - end.value[0] / H;
  const double speed = rootMeanSquare(
      r, [](const World& w, std::size_t i) { return length(w.particles.velocity[i]); });
  return {{"slump", std::abs(slump / slumpBy(2, yield) - 1), 0.1},
          {"slump by von Mises", std::abs(slump / slumpBy(std::sqrt(3.0), yield) - 1), 0.1},
          {"slump / H", slump},
          {"slump / H in the last tenth", (late.value[0] - end.value[0]) / H},
          {"rms speed at the end (m/s)", speed}};
}

}  // namespace

std::vector<Case> yieldCases() {
  const auto thicken = [](Scene& s) {
    makeThin(s);
    s.materials[0].flowLaw.exponent = 1.5;
  };
  return {{"bingham",
           "steady channel of a Bingham liquid, started at the exact profile (Bingham 1922)",
           nullptr,
           {},
           startYieldChannel,
           {},
           measureYieldChannel,
           makeThin},
          {"herschel_bulkley",
           "the same of a Herschel-Bulkley liquid with an exponent of 0.5 (Herschel & Bulkley 1926)",
           nullptr,
           {},
           startYieldChannel,
           {},
           measureYieldChannel,
           makeThin},
          {"herschel_bulkley_thick",
           "the same with an exponent of 1.5",
           "herschel_bulkley",
           {},
           startYieldChannel,
           {},
           measureYieldChannel,
           thicken},
          {"yield_slump",
           "slump of a cylinder of a Bingham liquid on a floor (P96)",
           nullptr,
           {},
           {},
           watchSlump,
           measureLiquidSlump}};
}

}  // namespace thaw::accuracy
