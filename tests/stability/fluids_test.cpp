// SPDX-License-Identifier: Apache-2.0
// Failures of density and pressure in liquids: rows of docs/validation/stability.md. Each test provokes the
// failure, shows a naive implementation fail where that is cheap, and checks the stated behaviour of thaw.
#include "core/kernels/kernels.hpp"
#include "tests/support/free_liquid.hpp"
#include "tests/support/hashed.hpp"
#include "tests/support/measured.hpp"

namespace thaw::test {
namespace {

constexpr double dx = liquidSpacing;

/// A cube of n^3 particles of liquid, all sides periodic, no gravity.
Scene periodicLiquid(int n) {
  Scene s;
  s.spacing = dx;
  s.domain.min = {0, 0, 0};
  s.domain.max = {n * dx, n * dx, n * dx};
  for (auto& side : s.domain.side) side = {Side::Periodic, Side::Periodic};
  s.domain.gravity = {};
  s.output.every = 0;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 10;
  addBox(s, s.domain.min, s.domain.max);
  return s;
}

/// Least and mean distance to the nearest other particle, in spacings.
struct Nearest {
  double least = never, mean = 0;
};
Nearest nearest(const std::vector<Vec3d>& x, double period = 0) {
  Nearest r;
  for (std::size_t i = 0; i < x.size(); i++) {
    double d = never;
    for (std::size_t j = 0; j < x.size(); j++) {
      Vec3d v = x[j] - x[i];
      for (int a = 0; a < 3 && period > 0; a++) v[a] -= period * std::round(v[a] / period);
      if (j != i) d = std::min(d, length(v));
    }
    r.least = std::min(r.least, d / dx);
    r.mean += d / dx / static_cast<double>(x.size());
  }
  return r;
}
std::vector<Vec3d> placesOf(const Continuum& p) { return {p.position.data(), p.position.data() + p.owned}; }

/// MCG03's poly6 used for the gradient as well, as a naive implementation.
struct Poly6 {
  static double w(double q2) { return isa_base::Mcg03::w(q2); }
  static double slope(double q2) {
    return -945 / (32 * std::numbers::pi) * std::pow(std::max(0.0, 1 - q2), 2);
  }
};

/// Damped motion of particles in a periodic cube under p = c^2 (relative density - 1) >= 0, by brute force.
template<class Kernel>
std::vector<Vec3d> relax(std::vector<Vec3d> x, double period, double onLattice, int steps) {
  const double h = 2 * dx, dt = 0.1 * h, n3 = dx * dx * dx / (h * h * h);
  std::vector<Vec3d> v(x.size());
  std::vector<double> term(x.size());
  for (int step = 0; step < steps; step++) {
    const auto pairs = [&](auto&& f) {
      for (std::size_t i = 0; i < x.size(); i++)
        for (std::size_t j = 0; j < x.size(); j++) {
          Vec3d d = x[i] - x[j];
          // wraps positions into the period
          for (int a = 0; a < 3; a++)
            d[a] -= d[a] > 0.5 * period ? period : d[a] < -0.5 * period ? -period : 0;
          const double q2 = dot(d, d) / (h * h);
          if (q2 < 1) f(i, j, d / h, q2);
        }
    };
    std::fill(term.begin(), term.end(), 0.0);
    pairs([&](std::size_t i, std::size_t, const Vec3d&, double q2) { term[i] += n3 * Kernel::w(q2); });
    for (double& t : term) t = std::max(0.0, t / onLattice - 1) * onLattice * onLattice / (t * t);
    for (Vec3d& u : v) u = 0.9 * u;
    pairs([&](std::size_t i, std::size_t j, const Vec3d& d, double q2) {
      if (i != j) v[i] -= dt * n3 / h * (term[i] + term[j]) * Kernel::slope(q2) * d;
    });
    for (std::size_t i = 0; i < x.size(); i++) x[i] += dt * v[i];
  }
  return x;
}

}  // namespace

TEST(Stability, Row06StretchedLiquid) {
  // 8 % too thin everywhere: negative pressure pulls the particles into clumps, most with poly6 and a wide
  // support
  Nearest result[2];
  for (const bool naive : {true, false}) {
    Scene s = periodicLiquid(12);
    s.materials[0].viscosity = {0.5, 0.5};
    if (naive) {
      s.numerics.kernel = KernelKind::Mcg03;
      s.numerics.support = 3;
      s.numerics.tensileLimit = 1;
    }
    s.materials[0].density = 1000;
    s.end = 0.1;
    Simulation run(s);
    Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned; i++) {
      p.mass[i] *= 0.92;
      for (int a = 0; a < 3; a++)
        p.position[i][a] += 0.05 * dx * (hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5);
    }
    EXPECT_TRUE(run.run());
    result[!naive] = nearest(placesOf(p), 12 * dx);
  }
  measured(
      "nearest neighbour after 0.1 s: least %.2f, mean %.2f spacings with poly6, h = 3 dx and negative "
      "pressure; %.2f, %.2f",
      result[0].least, result[0].mean, result[1].least, result[1].mean);
  EXPECT_LT(result[0].least, 0.5);
  EXPECT_GT(result[1].least, 0.85);
}

TEST(Stability, Row07FreeSurfaceDensity) {
  double fastest[2], relativeDensity[3] = {};
  for (const bool naive : {true, false}) {
    Scene s = freeLiquid();
    s.numerics.tensileLimit = naive ? 1 : 0;
    addBox(s, {-5 * dx, -5 * dx, -5 * dx}, {5 * dx, 5 * dx, 5 * dx});
    s.end = 0.01;
    Simulation run(s);
    const Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned && !naive; i++) {
      int sides = 0;
      for (int a = 0; a < 3; a++) sides += std::abs(p.position[i][a]) > 4.1 * dx;
      if (sides > 0) relativeDensity[sides - 1] = static_cast<double>(p.relativeDensity[i]);
    }
    double v = 0;
    while (run.w.clock.time < s.end) {
      ASSERT_TRUE(run.step());
      for (std::size_t i = 0; i < p.owned; i++) v = std::max(v, length(p.velocity[i]));
    }
    fastest[!naive] = v;
  }
  measured(
      "density ratio of face, edge, corner %.2f, %.2f, %.2f; a cube at rest moves at %.2f m/s (c = 10) with "
      "negative pressure, at %.1e",
      relativeDensity[0], relativeDensity[1], relativeDensity[2], fastest[0], fastest[1]);
  EXPECT_LT(relativeDensity[2], 0.7);
  EXPECT_GT(fastest[0], 1);
  EXPECT_LT(fastest[1], 1e-4);
}

TEST(Stability, Row08PressureThatVanishesForClosePairs) {
  // pairs at a tenth of a spacing in a liquid that is 10 % too dense; pressure should part them
  std::vector<Vec3d> x;
  const int n = 6;
  for (int k = 0; k < n * n * n; k++) {
    Vec3d at{(k % n + 0.5) * dx, (k / n % n + 0.5) * dx, (k / n / n + 0.5) * dx};
    if (k % 10 == 0) x.push_back(at + Vec3d{0.06 * dx, 0.06 * dx, 0.05 * dx});
    x.push_back(at);
  }
  double sum[2] = {};
  for (int i = -3; i <= 3; i++)
    for (int j = -3; j <= 3; j++)
      for (int k = -3; k <= 3; k++) {
        const double q2 = (i * i + j * j + k * k) / 4.0;
        sum[0] += q2 < 1 ? Poly6::w(q2) / 8 : 0;
        sum[1] += q2 < 1 ? isa_base::WendlandC2::w(q2) / 8 : 0;
      }
  const Nearest naive = nearest(relax<Poly6>(x, n * dx, sum[0], 400), n * dx),
                plain = nearest(relax<isa_base::WendlandC2>(x, n * dx, sum[1], 400), n * dx);
  Scene s = periodicLiquid(n);
  s.materials[0].viscosity = {0.5, 0.5};
  s.end = 0.2;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.mass[i] *= 1.1;
  for (std::size_t i = 1; i < p.owned; i += 10)
    p.position[i] = p.position[i - 1] + Vec3d{0.06 * dx, 0.06 * dx, 0.05 * dx};
  EXPECT_TRUE(run.run());
  const Nearest ours = nearest(placesOf(p), n * dx);
  measured(
      "least distance of pairs that began at 0.10 spacings: %.2f with poly6, %.2f with wendland in the same "
      "loop; a scene: %.2f",
      naive.least, plain.least, ours.least);
  EXPECT_LT(naive.least, 0.2);
  EXPECT_GT(plain.least, 0.4);
  EXPECT_GT(ours.least, 0.4);
}

TEST(Stability, Row09CoincidentParticles) {
  Scene s = periodicLiquid(8);
  s.materials[0].viscosity = {0.5, 0.5};
  s.materials[0].surfaceTension = 0.07;
  s.end = 0.1;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 1; i < p.owned; i += 50)
    p.position[i] = p.position[i - 1], p.velocity[i] = p.velocity[i - 1];
  const Vec3d together = p.position[0] - p.position[1];
  EXPECT_TRUE(std::isnan((together / length(together)).x));  // a naive force has no direction
  ASSERT_TRUE(run.step());
  const std::int64_t counted = run.w.counters.coincidentPairs;
  EXPECT_TRUE(run.run());
  const Nearest n = nearest(placesOf(p), 8 * dx);
  measured(
      "11 pairs in the same place: %lld ends counted in the first step, least distance after 0.1 s %.2f "
      "spacings",
      static_cast<long long>(counted), n.least);
  EXPECT_EQ(counted, 22);
  EXPECT_GT(n.least, 0.3);
  EXPECT_EQ(run.ledgerReport().massResidual, 0);
}

TEST(Stability, Row12DensityLayers) {
  // a light liquid on one a thousand times as dense, both at rest
  Scene s = columnScene(dx, 0, 12 * dx);
  s.domain.side[2] = {Side::Wall, Side::Wall};
  s.materials.emplace_back(s.materials[0]);
  s.materials[1].name = "light";
  s.materials[0].density = 1000, s.materials[1].density = 1;
  for (Material& m : s.materials) m.soundSpeed = 10, m.viscosity = {m.density * 1e-3, m.density * 1e-3};
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 6 * dx});
  addBox(s, {0, 0, 6 * dx}, {6 * dx, 6 * dx, 12 * dx}).material = 1;
  s.end = 0.05;
  Simulation run(s);
  const Continuum& p = run.particles();
  // density of a light particle at the interface from the sum of masses, over its rest density
  double summed = 0;
  const double h = 2 * dx;
  for (std::size_t j = 0; j < p.owned; j++) {
    Vec3d d = p.position[j] - Vec3d{0.5 * dx, 0.5 * dx, 6.5 * dx};
    for (int a = 0; a < 2; a++) d[a] -= 6 * dx * std::round(d[a] / (6 * dx));
    const double q2 = dot(d, d) / (h * h);
    if (q2 < 1) summed += p.mass[j] * isa_base::WendlandC2::w(q2) / (h * h * h);
  }
  double largest = 0, fastest = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    largest = std::max(largest, std::abs(static_cast<double>(p.relativeDensity[i]) - 1));
  EXPECT_TRUE(run.run());
  for (std::size_t i = 0; i < p.owned; i++) fastest = std::max(fastest, length(p.velocity[i]));
  measured(
      "density ratio of a light particle at the interface: %.0f with summed masses; within %.1e of 1; "
      "fastest "
      "after 0.05 s %.1e m/s (c = 10)",
      summed, largest, fastest);
  EXPECT_GT(summed, 100);
  EXPECT_LT(largest, 0.02);
  EXPECT_LT(fastest, 0.02);
}

}  // namespace thaw::test
