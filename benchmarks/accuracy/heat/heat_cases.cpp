// SPDX-License-Identifier: Apache-2.0
// Heat conduction and melting against exact solutions (docs/validation/accuracy.md).
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

const Material& materialOf(const Scene& s, std::size_t body) {
  return s.materials[static_cast<std::size_t>(s.bodies[body].material)];
}
double diffusivityOf(const Material& m) { return m.conductivity.at(1) / (m.density * m.heatCapacity.at(1)); }

/// Unexplained heat of the ledger, relative to `scale`.
double heatResidual(Trial& r, double scale) {
  const LedgerReport ledgerReport = reportLedger(r.world, r.tools, r.all);
  return std::abs(ledgerReport.heatResidual) /
         (scale * ledgerReport.now.mass * r.world.scene.materials[0].heatCapacity.at(1));
}

/// Root of an increasing function in [low, high].
template<class F> double rootOf(double low, double high, F f) {
  for (int n = 0; n < 200; n++) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Two half-spaces in contact at z = 0. The interface is at (e1 T1 + e2 T2)/(e1 + e2), e = sqrt(k rho c), at
/// once, with error functions on both sides (CJ59 2.8).
std::vector<Figure> measureSlabs(Trial& r) {
  const Scene& s = r.world.scene;
  const double T[2] = {s.bodies[0].temperature, s.bodies[1].temperature}, scale = std::abs(T[1] - T[0]);
  double e[2], a[2];
  for (std::size_t k = 0; k < 2; k++) {
    const Material& m = materialOf(s, k);
    a[k] = diffusivityOf(m);
    e[k] = m.conductivity.at(1) / std::sqrt(a[k]);
  }
  const double middle = (e[0] * T[0] + e[1] * T[1]) / (e[0] + e[1]);
  const auto error = [&](const World& w, std::size_t i) {
    const double z = w.particles.position[i].z;
    const int k = z > 0;
    return (w.particles.temperature[i] - middle -
            (T[k] - middle) * std::erf(std::abs(z) / (2 * std::sqrt(a[k] * w.clock.time)))) /
           scale;
  };
  return {
      {"L2(T)", rootMeanSquare(r, error)},
      {"Linf(T)", largest(r, [&](const World& w, std::size_t i) { return std::abs(error(w, i)); }), 0.005},
      {"heat residual", heatResidual(r, scale), 1e-12}};
}

/// Mean and centre of a sphere whose surface takes the bath's temperature at once: mean 6/pi^2 sum exp(-n^2
/// pi^2 Fo)/n^2 (C75 6.3). With a Biot number: zeta cot zeta = 1 - Bi (CJ59 9.4).
struct Sphere {
  double mean = 0, centre = 0;
  Sphere(double Fo, double Bi) {
    for (int n = 1; n <= 60; n++) {
      if (!(Bi < never)) {
        const double z = n * pi, decay = std::exp(-z * z * Fo);
        mean += 6 / (z * z) * decay;
        centre += 2 * (n % 2 ? 1 : -1) * decay;
        continue;
      }
      const double low = (n - 1) * pi + 1e-9,
                   z = rootOf(low, n * pi - 1e-9, [&](double x) { return 1 - Bi - x / std::tan(x); });
      const double decay = std::exp(-z * z * Fo),
                   C = 4 * (std::sin(z) - z * std::cos(z)) / (2 * z - std::sin(2 * z));
      mean += C * decay * 3 * (std::sin(z) - z * std::cos(z)) / (z * z * z);
      centre += C * decay;
    }
  }
};

std::vector<Figure> measureSphere(Trial& r) {
  const World& w = r.world;
  const Scene& s = w.scene;
  const Material& m = materialOf(s, 0);
  const bool bath = !s.obstacles.empty();
  const double R = s.bodies[0].shape.radius, hot = s.bodies[0].temperature,
               cold = bath ? *s.obstacles[0].temperature : s.domain.ambient;
  const Sphere exact(diffusivityOf(m) * w.clock.time / (R * R),
                     bath ? never : m.convection * R / m.conductivity.at(1));
  const auto theta = [&](const World& x, std::size_t i) {
    return (x.particles.temperature[i] - cold) / (hot - cold);
  };
  const double mass = sum(r, [](const World& x, std::size_t i) { return x.particles.mass[i]; });
  const double mean = sum(r,
                          [&](const World& x, std::size_t i) { return x.particles.mass[i] * theta(x, i); }) /
                      mass;
  // centre: mean within two spacings, extrapolated to r = 0 by the curvature of the first exact mode
  const double near = 2 * s.spacing;
  const auto inside = [&](const World& x, std::size_t i) {
    return length(x.particles.position[i]) < near ? 1.0 : 0.0;
  };
  const double count = sum(r, inside),
               middle = sum(r, [&](const World&x, std::size_t i) { return inside(x, i) * theta(x, i); }) /
                        count;
  const double square = sum(r,
                            [&](const World& x, std::size_t i) {
                              return inside(x, i) * dot(x.particles.position[i], x.particles.position[i]);
                            }) /
                        count;
  const double zeta = bath ? pi : rootOf(1e-9, pi - 1e-9, [&](double x) {
    return 1 - m.convection * R / m.conductivity.at(1) - x / std::tan(x);
  });
  return {{"mean T", std::abs(mean / exact.mean - 1)},
          {"centre T", std::abs(middle * (1 + zeta * zeta * square / (6 * R * R)) / exact.centre - 1)},
          {"heat residual", heatResidual(r, hot - cold), 1e-12}};
}

/// Front of melting from a wall: 2 l sqrt(alpha t). Two phases: Neumann's solution (CJ59 11.2) for equal
/// properties, Ste exp(-l^2)/erf l - Ste_s exp(-l^2)/erfc l = l sqrt(pi).
std::vector<Figure> measureStefan(Trial& r) {
  const World& w = r.world;
  const Scene& s = w.scene;
  const Material& m = materialOf(s, 0);
  const double hot = *s.obstacles[0].temperature, c = m.heatCapacity.at(1), a = diffusivityOf(m);
  const double ste = c * (hot - m.solidus) / m.latentHeat,
               below = c * (m.solidus - s.bodies[0].temperature) / m.latentHeat;
  const double l = rootOf(1e-6, 3, [&](double x) {
    return x * std::sqrt(pi) - std::exp(-x * x) * (ste / std::erf(x) - below / std::erfc(x));
  });
  const double front = 2 * l * std::sqrt(a * w.clock.time),
               area = (s.domain.max.x - s.domain.min.x) * (s.domain.max.y - s.domain.min.y);
  const double melted = sum(r,
                            [](const World& x, std::size_t i) {
                              return x.particles.mass[i] * static_cast<double>(x.particles.liquid[i]);
                            }) /
                        (m.density * area);
  const auto error = [&](const World& x, std::size_t i) {
    const double eta = x.particles.position[i].z / (2 * std::sqrt(a * x.clock.time));
    const double T = eta < l ? hot + (m.solidus - hot) * std::erf(eta) / std::erf(l)
                             : s.bodies[0].temperature +
                                   (m.solidus - s.bodies[0].temperature) * std::erfc(eta) / std::erfc(l);
    return (x.particles.temperature[i] - T) / (hot - m.solidus);
  };
  return {{"front", std::abs(melted / front - 1), 0.005},
          {"L2(T)", rootMeanSquare(r, error)},
          {"heat residual", heatResidual(r, hot - m.solidus), 1e-12}};
}

}  // namespace

std::vector<Case> heatCases() {
  return {
      {.name = "slabs",
       .about = "slabs in contact against error functions (Carslaw & Jaeger 1959)",
       .measure = measureSlabs,
       .adapt = makeThin},
      {.name = "conductivity_ratio",
       .about = "slabs of conductivities 1:10 in contact against error functions (Cleary & Monaghan 1999)",
       .measure = measureSlabs,
       .adapt = makeThin},
      {.name = "sphere_bath",
       .about = "ball whose surface is kept at a temperature, Fo = 0.1 (Crank 1975)",
       .measure = measureSphere},
      {.name = "sphere_biot",
       .about = "ball that convects heat at its surface, Bi = 1, Fo = 0.5 (Carslaw & Jaeger 1959)",
       .measure = measureSphere},
      {.name = "stefan_one_phase",
       .about = "melting from a wall, solid at its melting temperature, Ste = 0.5 (Stefan)",
       .measure = measureStefan,
       .adapt = makeThin},
      {.name = "stefan_two_phase",
       .about = "melting from a wall, solid below its melting temperature (Neumann)",
       .measure = measureStefan,
       .adapt = makeThin}};
}

}  // namespace thaw::accuracy
