// SPDX-License-Identifier: Apache-2.0
// Cantilevers of square section against the beam theory of Timoshenko (T21), with kappa of Cowper (C66).
#include "benchmarks/accuracy/solid/solid_trials.hpp"

namespace thaw::accuracy {
namespace {

struct Beam {
  double length = 5, height = 1, E, G, density, gravity;
  explicit Beam(const World& w)
      : E(materialOf(w).young.solid),
        G(constantsOf(w).mu),
        density(materialOf(w).density),
        gravity(-w.scene.domain.gravity.z) {}
  double bending() const { return E * std::pow(height, 4) / 12; }
  double shear(double nu) const { return 10 * (1 + nu) / (12 + 11 * nu) * G * height * height; }
  /// Deflection (m) at x under its own weight.
  double sag(double x, double nu) const {
    const double q = density * gravity * height * height;
    return q * x * x * (x * x - 4 * length * x + 6 * length * length) / (24 * bending()) +
           q * (length * x - 0.5 * x * x) / shear(nu);
  }
  /// Mode shape of a slender cantilever, cosh - cos - s (sinh - sin). That of a thicker beam hardly differs.
  double mode(double x) const {
    const double a = 1.8751040687 * x / length, s = 0.7340955;
    return std::cosh(a) - std::cos(a) - s * (std::sinh(a) - std::sin(a));
  }
};

/// First frequency (Hz) for length 5, height 1, E = 1e6, rho = 1000 (T21).
constexpr double firstFrequency = 0.1982;

bool atTip(const World& w, std::size_t i) { return w.particles.position[i].x > 5 - w.scene.spacing; }

double tipHeight(Trial& r) {
  const double n = sum(r, [](const World& w, std::size_t i) { return atTip(w, i) ? 1.0 : 0.0; });
  return sum(r, [](const World& w, std::size_t i) { return atTip(w, i) ? w.particles.position[i].z : 0.0; }) /
         n;
}

/// Friction with a fixed medium, near the critical value of the first mode.
void dampBeam(Trial& r) {
  World& w = r.world;
  const double keep = std::exp(-2 * 2 * pi * firstFrequency * w.clock.stepDt);
  for (std::size_t i = 0; i < w.particles.owned; i++)
    w.particles.velocity[i] = w.particles.velocity[i] * keep;
}

std::vector<Figure> measureSag(Trial& r) {
  const Beam beam(r.world);
  const double nu = materialOf(r.world).poisson.solid, dx = r.spacing();
  const double measured = -tipHeight(r), fastest = largest(r, [](const World&w, std::size_t i) {
                                           return length(w.particles.velocity[i]);
                                         });
  const double target = dx < 0.1 ? 0.03 : 0.05;
  Beam clamped = beam;  // clamped in the plane of the outermost clamped particles, half a spacing behind the
                        // face
  clamped.length += 0.5 * dx;
  return {{"deflection", std::abs(measured / beam.sag(5 - 0.5 * dx, nu) - 1), target},
          {"deflection from clamped plane", std::abs(measured / clamped.sag(5, nu) - 1)},
          {"still moving", fastest / (firstFrequency * measured)}};
}

void strike(Trial& r) {
  World& w = r.world;
  const Beam beam(w);
  for (std::size_t i = 0; i < w.particles.owned; i++)
    if (!w.particles.clamped[i]) w.particles.velocity[i].z = 1e-3 * beam.mode(w.particles.position[i].x);
}

void watchTip(Trial& r) { r.series.push_back({r.world.clock.time, {tipHeight(r)}}); }

std::vector<Figure> measureFrequency(Trial& r) {
  std::vector<double> t = crossings(r.series, 0);
  // half a period between zeros
  const double measured = t.size() < 2 ? 0 : 0.5 * static_cast<double>(t.size()) / t.back();
  return {{"first frequency", std::abs(measured / firstFrequency - 1), 0.03}};
}

// ---- spectrum ---------------------------------------------------------------------------------------------
constexpr std::size_t probes = 4;

/// Weights of a displacement of the body that is white in space, so that it contains every mode.
double probe(const World& w, std::size_t i, int axis, std::size_t k) {
  return randomUniform(w.scene.seed, Purpose::Test, w.particles.id[i],
                       3 * k + static_cast<std::size_t>(axis)) -
         0.5;
}

void shake(Trial& r) {
  World& w = r.world;
  for (std::size_t i = 0; i < w.particles.owned; i++)
    for (int a = 0; a < 3 && !w.particles.clamped[i]; a++)
      w.particles.velocity[i][a] = 1e-3 * probe(w, i, a, probes);
}

void watchProbes(Trial& r) {
  Sample s{r.world.clock.time, {}};
  for (std::size_t k = 0; k < probes; k++)
    s.value.push_back(sum(r, [&](const World& w, std::size_t i) {
      const Vec3d v = w.particles.velocity[i];
      return v.x * probe(w, i, 0, k) + v.y * probe(w, i, 1, k) + v.z * probe(w, i, 2, k);
    }));
  r.series.push_back(s);
}

/// Amplitude of all probes at a frequency (Hz), with Hann's window.
double amplitude(const Trial& r, double frequency) {
  double power = 0;
  const double end = r.series.back().time;
  for (std::size_t k = 0; k < probes; k++) {
    double re = 0, im = 0;
    for (std::size_t n = 1; n < r.series.size(); n++) {
      const Sample& s = r.series[n];
      const double weight = (s.time - r.series[n - 1].time) * std::pow(std::sin(pi * s.time / end), 2) *
                            s.value[k];
      re += weight * std::cos(2 * pi * frequency * s.time);
      im += weight * std::sin(2 * pi * frequency * s.time);
    }
    power += re * re + im * im;
  }
  return std::sqrt(power);
}

double largestLine(const Trial& r, double from, double to) {
  double most = 0;
  for (double f = from; f < to; f += 0.01) most = std::max(most, amplitude(r, f));
  return most;
}

// Neither below bending (0.198 Hz) nor between bending and torsion (0.901 Hz) is there a mode. A line is 0.1
// Hz wide to each side in 20 s.
std::vector<Figure> measureLines(Trial& r) {
  const double first = largestLine(r, 0.1, 0.3);
  return {{"lines between/first", largestLine(r, 0.35, 0.72) / first, 0.05},
          {"below 0.06 Hz/first", largestLine(r, 0, 0.06) / first},
          {"torsion/first", largestLine(r, 0.8, 1) / first}};
}

}  // namespace

std::vector<Case> beamCases() {
  return {{"cantilever",
           "sag of a clamped beam; q L^4/(8EI) + q L^2/(2 kappa G A)",
           nullptr,
           {},
           {},
           dampBeam,
           measureSag},
          {"cantilever_vibration",
           "first frequency of the same beam; Timoshenko",
           nullptr,
           {},
           strike,
           watchTip,
           measureFrequency},
          {"cantilever_modes",
           "the same beam shaken at random: no lines between bending and torsion "
           "(docs/validation/stability.md, row 2)",
           nullptr,
           {},
           shake,
           watchProbes,
           measureLines}};
}

}  // namespace thaw::accuracy
