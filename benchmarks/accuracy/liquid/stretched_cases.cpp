// SPDX-License-Identifier: Apache-2.0
// Liquids without walls or gravity that deform in their own flow: Taylor's elliptic drop and the rotating
// square patch.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/gathered.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;
constexpr double link = 1.75;  // spacings; longer than the lattice's diagonal links, shorter than a gap of
                               // two

/// A periodic slab around z = 0, three support radii and at least six spacings thick.
void makeSlab(Scene& s) {
  const double thickness = std::max(6.0, std::ceil(3 * s.numerics.support)) * s.spacing;
  s.domain.min.z = -0.5 * thickness;
  s.domain.max.z = 0.5 * thickness;
  for (Body& b : s.bodies) b.shape.size.z = b.shape.height = thickness;
}

double kineticEnergy(Trial& r) {
  return sum(r, [](const World& w, std::size_t i) {
    return 0.5 * w.particles.mass[i] * dot(w.particles.velocity[i], w.particles.velocity[i]);
  });
}

/// Volume (m^3) from mass over summed density.
double densityVolume(Trial& r) {
  return sum(r, [](const World& w, std::size_t i) {
    const double relative = static_cast<double>(w.particles.relativeDensity[i]),
                 rest = w.scene.materials[0].density;
    return relative > 0 ? w.particles.mass[i] / (rest * relative) : 0;
  });
}

/// Angular momentum (kg m^2/s) about the z axis through the origin.
double spinMomentum(Trial& r) {
  return sum(r, [](const World& w, std::size_t i) {
    const Vec3d &x = w.particles.position[i], &v = w.particles.velocity[i];
    return w.particles.mass[i] * (x.x * v.y - x.y * v.x);
  });
}

double farthest(Trial& r, int axis) {
  return largest(r,
                 [axis](const World& w, std::size_t i) { return std::abs(w.particles.position[i][axis]); });
}
double spread(Trial& r, int axis) {
  return rootMeanSquare(r, [axis](const World& w, std::size_t i) { return w.particles.position[i][axis]; });
}

/// Adds residuals of the ledger: energy relative to the initial kinetic energy, momentum relative to m
/// `speed`.
void addResiduals(Trial& r, double speed, std::vector<Figure>& figures) {
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  figures.push_back({"energy residual", std::abs(ledger.energyResidual) / r.notes["energy"], 0.01});
  figures.push_back({"momentum residual", length(ledger.momentumResidual) / (ledger.now.mass * speed), 1e-9});
}

void recordStart(Trial& r) {
  r.notes["energy"] = kineticEnergy(r);
  r.notes["volume"] = densityVolume(r);
  r.notes["spin"] = spinMomentum(r);
  for (int a = 0; a < 2; a++) {
    r.notes["farthest" + std::to_string(a)] = farthest(r, a);
    r.notes["spread" + std::to_string(a)] = spread(r, a);
  }
  r.notes["inner"] = meanInnerDensity(r.world.scene.domain, r.spacing(), gather(r));
}

void addShape(Trial& r, double densityTarget, std::vector<Figure>& figures) {
  const std::vector<GatheredParticle> all = gather(r);
  const Domain& domain = r.world.scene.domain;
  const Components parts = findComponents(domain, all, link * r.spacing());
  figures.push_back({"fragments", static_cast<double>(parts.count - 1), 0});
  figures.push_back({"mass outside the largest part", 1 - parts.largestShare});
  const double inner = meanInnerDensity(domain, r.spacing(), all) / r.notes["inner"];
  figures.push_back({"inner density / start", inner});
  figures.push_back({"inner density", std::abs(inner - 1), densityTarget});
}

// ---- elliptic drop ----------------------------------------------------------------------------------------

constexpr double stretchRate = 100;  // 1/s, A at time 0

/// Half axes over the radius of the circle, and the rate A of the flow (-A x, A y).
struct Ellipse {
  double a = 1, b = 1, rate = stretchRate;
};

/// Integrates dA/dt = A^2 (a^4 - 1)/(a^4 + 1), da/dt = -a A, b = 1/a (M94) to rounding by a
/// Runge-Kutta method.
Ellipse ellipseAt(double time) {
  using State = std::array<double, 2>;  // a, A
  const auto rates = [](const State& s) {
    const double a4 = std::pow(s[0], 4);
    return State{-s[0] * s[1], s[1] * s[1] * (a4 - 1) / (a4 + 1)};
  };
  const auto moved = [](const State& s, const State& k, double dt) {
    return State{s[0] + dt * k[0], s[1] + dt * k[1]};
  };
  constexpr int steps = 10000;
  const double dt = time / steps;
  State s{1, stretchRate};
  for (int n = 0; n < steps; n++) {
    const State k1 = rates(s), k2 = rates(moved(s, k1, 0.5 * dt)), k3 = rates(moved(s, k2, 0.5 * dt)),
                k4 = rates(moved(s, k3, dt));
    for (std::size_t c = 0; c < 2; c++) s[c] += dt / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
  }
  return {s[0], 1 / s[0], s[1]};
}

void stretchDrop(Trial& r) {
  Continuum& p = r.world.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    p.velocity[i] = {-stretchRate * p.position[i].x, stretchRate * p.position[i].y, 0};
  recordStart(r);
}

/// The flow is linear, so x and y of every particle grow as the half axes. Moments and outermost particles
/// are compared with their initial values.
std::vector<Figure> measureDrop(Trial& r) {
  const World& w = r.world;
  const Ellipse exact = ellipseAt(w.clock.time);
  const double R = w.scene.bodies[0].shape.radius, target = 0.6 * r.spacing() / R;  // 3 % at R/dx = 20
  const double a = spread(r, 0) / r.notes["spread0"], b = spread(r, 1) / r.notes["spread1"];
  const double left = farthest(r, 0) / r.notes["farthest0"], top = farthest(r, 1) / r.notes["farthest1"];
  std::vector<Figure> f{{"a (moments)", std::abs(a / exact.a - 1), target},
                        {"b (moments)", std::abs(b / exact.b - 1), target},
                        {"a (outermost)", std::abs(left / exact.a - 1), target},
                        {"b (outermost)", std::abs(top / exact.b - 1), target},
                        {"area (moments)", std::abs(a * b - 1), 0.02},
                        {"area (outermost)", std::abs(left * top - 1), 0.02},
                        {"area (density)", std::abs(densityVolume(r) / r.notes["volume"] - 1), 0.02},
                        {"a / exact", a / exact.a},
                        {"b / exact", b / exact.b},
                        {"kinetic energy", std::abs(kineticEnergy(r) / r.notes["energy"] - 1)}};
  addShape(r, never, f);
  addResiduals(r, R * stretchRate, f);
  return f;
}

// ---- rotating patch ---------------------------------------------------------------------------------------

/// Distances of the four arms' tips from the axis: the outermost particle of each quarter. Quarters are
/// turned so that the farthest particle is in the middle of one.
std::array<double, 4> armsOf(const std::vector<GatheredParticle>& all) {
  double most = 0, first = 0;
  for (const GatheredParticle& p : all)
    if (const double radius = std::hypot(p.position.x, p.position.y); radius > most)
      most = radius, first = std::atan2(p.position.y, p.position.x);
  std::array<double, 4> arms{};
  for (const GatheredParticle& p : all) {
    const double quarter = (std::atan2(p.position.y, p.position.x) - first) / (0.5 * pi);
    const auto arm = static_cast<std::size_t>((static_cast<int>(std::lround(quarter)) + 8) % 4);
    arms[arm] = std::max(arms[arm], std::hypot(p.position.x, p.position.y));
  }
  return arms;
}

std::vector<Figure> measurePatch(Trial& r) {
  const Body& body = r.world.scene.bodies[0];
  const double half = 0.5 * body.shape.size.x;
  const std::array<double, 4> arms = armsOf(gather(r));
  const auto [shortest, longest] = std::minmax_element(arms.begin(), arms.end());
  std::vector<Figure> f{{"angular momentum", std::abs(spinMomentum(r) / r.notes["spin"] - 1), 0.02},
                        {"difference of the arms", (*longest - *shortest) / *longest, 0.05},
                        {"longest arm / half a diagonal", *longest / (std::sqrt(2.0) * half)},
                        {"area (density)", std::abs(densityVolume(r) / r.notes["volume"] - 1), 0.02},
                        {"kinetic energy / start", kineticEnergy(r) / r.notes["energy"]}};
  addShape(r, 0.1, f);
  addResiduals(r, length(body.spin) * half, f);
  return f;
}

}  // namespace

std::vector<Case> stretchedCases() {
  return {
      {.name = "elliptic_drop",
       .about = "a circle of liquid that a linear flow stretches to an ellipse; half axes (Monaghan 1994)",
       .start = stretchDrop,
       .measure = measureDrop,
       .adapt = makeSlab},
      {.name = "rotating_patch",
       .about = "a spinning square of liquid: four arms, in one piece, at the density of the start (Le Touze "
                "et al. 2013)",
       .start = recordStart,
       .measure = measurePatch,
       .adapt = makeSlab}};
}

}  // namespace thaw::accuracy
