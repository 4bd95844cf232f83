// SPDX-License-Identifier: Apache-2.0
// Viscosity against exact solutions (docs/validation/accuracy.md): a channel, and a rigidly rotating drop.
// drop_cases.cpp has drops with tension.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/liquid/drop_cases.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

/// Flow between walls at z = 0 and H, driven along x by gravity.
struct Channel {
  double height, nu, fastest;
  explicit Channel(const Scene& s)
      : height(s.domain.max.z - s.domain.min.z),
        nu(s.materials[0].viscosity.liquid / s.materials[0].density) {
    fastest = s.domain.gravity.x * height * height / (8 * nu);
  }
  double steady(double z) const { return 4 * fastest * z * (height - z) / (height * height); }
  /// Fourier series of the flow from rest (MFZ97 eq. 21).
  double starting(double z, double t) const {
    double u = steady(z);
    for (int n = 1; n < 200; n += 2) {
      const double k = n * pi / height;
      u -= 32 * fastest / (pi * pi * pi * n * n * n) * std::sin(k * z) * std::exp(-nu * k * k * t);
    }
    return u;
  }
};

std::vector<Figure> measurePoiseuille(Trial& r) {
  const Channel exact(r.world.scene);
  const auto u = [](const World& w, std::size_t i) { return w.particles.velocity[i]; };
  const auto error = [&](const World& w, std::size_t i) {
    return (u(w, i).x - exact.steady(w.particles.position[i].z)) / exact.fastest;
  };
  const auto across = [&](const World& w, std::size_t i) {
    return std::hypot(u(w, i).y, u(w, i).z) / exact.fastest;
  };
  const double n = sum(r, [](const World&, std::size_t) { return 1.0; });
  // flow rate over that of the exact profile: the effective viscosity without the noise of single particles
  const double flow = sum(r, [&](const World& w, std::size_t i) { return u(w, i).x; }) /
                          (n * exact.fastest * 2 / 3) -
                      1;
  return {{"L2(u)", rootMeanSquare(r, error), 0.01},
          {"flow rate / exact", 1 + flow},
          {"L2(u across)", rootMeanSquare(r, across)}};
}

void startSteady(Trial& r) {
  Continuum& p = r.world.particles;
  const Channel exact(r.world.scene);
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i].x = exact.steady(p.position[i].z);
}

/// Records L2(u) at 0.05, 0.1, 0.2 and 0.4 H^2 / nu.
void watchStarting(Trial& r) {
  const Channel exact(r.world.scene);
  const double t = r.world.clock.time, due = 0.05 * std::pow(2.0, static_cast<double>(r.series.size())) *
                                             exact.height * exact.height / exact.nu;
  if (t < due) return;
  const auto error = [&](const World& w, std::size_t i) {
    return (w.particles.velocity[i].x - exact.starting(w.particles.position[i].z, t)) / exact.fastest;
  };
  r.series.push_back({t, {rootMeanSquare(r, error)}});
}

std::vector<Figure> measureStarting(Trial& r) {
  double worst = 0;
  for (const Sample& s : r.series) worst = std::max(worst, s.value[0]);
  return {{"L2(u) at the worst time", worst, 0.01}};
}

struct Motion {
  Vec3d momentum, angular;
  double mass = 0;
};

Motion motionOf(Trial& r) {
  const LedgerReport ledgerReport = reportLedger(r.world, r.tools, r.all);
  return {ledgerReport.now.momentum, ledgerReport.now.angularMomentum, ledgerReport.now.mass};
}

void recordMotion(Trial& r) {
  const Motion m = motionOf(r);
  for (int a = 0; a < 3; a++) {
    r.notes["P" + std::to_string(a)] = m.momentum[a];
    r.notes["L" + std::to_string(a)] = m.angular[a];
  }
}

std::vector<Figure> measureSpin(Trial& r) {
  const World& w = r.world;
  const Material& m = w.scene.materials[0];
  const double nu = m.viscosity.liquid / m.density, R = w.scene.bodies[0].shape.radius,
               spin = length(w.scene.bodies[0].spin);
  const Motion end = motionOf(r);
  Vec3d lost, pushed;
  for (int a = 0; a < 3; a++) {
    lost[a] = r.notes["L" + std::to_string(a)] - end.angular[a];
    pushed[a] = end.momentum[a] - r.notes["P" + std::to_string(a)];
  }
  Vec3d before;
  for (int a = 0; a < 3; a++) before[a] = r.notes["L" + std::to_string(a)];
  return {{"loss of angular momentum", length(lost) / length(before) / w.clock.time * R * R / nu, 0.05},
          {"linear momentum", length(pushed) / (end.mass * spin * R), 1e-5}};
}

}  // namespace

std::vector<Case> viscousCases() {
  std::vector<Case> all = {
      {"poiseuille",
       "steady channel, started at the exact profile; parabola",
       nullptr,
       {},
       startSteady,
       {},
       measurePoiseuille,
       makeThin},
      {"poiseuille_startup",
       "channel from rest; Fourier series (Morris et al. 1997)",
       "poiseuille",
       {},
       {},
       watchStarting,
       measureStarting,
       makeThin},
      {"thick_channel",
       "channel from rest to steady flow, explicit steps a hundred times shorter than sound's; parabola",
       nullptr,
       {},
       {},
       {},
       measurePoiseuille,
       makeThin},
      {"spinning_drop",
       "free viscous drop in rigid rotation; angular momentum is constant",
       nullptr,
       {},
       recordMotion,
       {},
       measureSpin},
  };
  for (Case& c : dropCases()) all.push_back(std::move(c));
  return all;
}

}  // namespace thaw::accuracy
