// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "core/kernels/viscous_weight.hpp"
#include "tests/support/lattice.hpp"

namespace thaw::test {
namespace {

using Kernel = isa_base::WendlandC2;

struct Reference {
  std::vector<double> relativeDensity, heat;
  std::vector<Vec3d> force;
};

/// The same sums by brute force over all pairs, in double.
Reference bruteForce(const Block& b, double relativeDensityScale) {
  const Continuum& p = b.particles;
  const double h = b.grid.support;
  const std::size_t n = p.owned;
  Reference r{std::vector<double>(n), std::vector<double>(n), std::vector<Vec3d>(n)};
  std::vector<double> term(n);
  const auto V = [&](std::size_t i) { return p.mass[i] / b.scene.materials[0].density; };
  for (std::size_t i = 0; i < n; i++) {
    for (std::size_t j = 0; j < n; j++) {
      const Vec3d d = (p.position[i] - p.position[j]) / h;
      r.relativeDensity[i] += V(j) * Kernel::w(dot(d, d)) * relativeDensityScale;
    }
    term[i] = std::max(0.0, b.liquids[0].stiffness * (r.relativeDensity[i] - 1)) /
              (r.relativeDensity[i] * r.relativeDensity[i]);
  }
  for (std::size_t i = 0; i < n; i++)
    for (std::size_t j = 0; j < n; j++) {
      if (i == j) continue;
      const Vec3d d = (p.position[i] - p.position[j]) / h, u = p.velocity[i] - p.velocity[j];
      const double q2 = dot(d, d), VV = V(i) * V(j), slope = Kernel::slope(q2);
      r.force[i] += d * (-VV * (term[i] + term[j]) * slope * relativeDensityScale / h -
                         VV * dot(u, d) / (q2 + 1e-6) * isa_base::alongPair(ViscousWeight{}.scale, q2) /
                             (h * h * h * h * h));
      r.heat[i] += VV * -2 * slope / (h * h * h * h * h) * (p.temperature[j] - p.temperature[i]);
    }
  return r;
}

}  // namespace

class PairSumsTest : public testing::TestWithParam<Precision> {};

TEST_P(PairSumsTest, AgreeWithBruteForce) {
  Block b(9, 0.2, 2, GetParam());
  b.modules.contact = true;
  b.findNeighbours(*pairKernels());
  std::int64_t coincident = 0;
  PairSums s = b.sums(&coincident);
  const RecordContext x{b.scene, b.modules, b.grid, b.liquids};
  pairKernels()->density(s, b.groups());
  packPressure(x, b.particles, 0, b.particles.owned, b.records);
  pairKernels()->forces(s, b.groups());
  const Reference r = bruteForce(b, s.relativeDensityScale);
  // the relative density is stored as float, which the stiffness amplifies
  const double tolerance = GetParam() == Precision::Single ? 2e-5 : 1e-6;
  double scale = 0, heatScale = 0;
  for (std::size_t i = 0; i < b.particles.owned; i++)
    scale = std::max(scale, length(r.force[i])), heatScale = std::max(heatScale, std::abs(r.heat[i]));
  Vec3d total{};
  double heat = 0;
  for (std::size_t i = 0; i < b.particles.owned; i++) {
    EXPECT_NEAR(b.particles.relativeDensity[i], r.relativeDensity[i], 1e-6);
    EXPECT_LT(length(b.particles.force[i] - r.force[i]), tolerance * scale) << i;
    EXPECT_NEAR(b.particles.heatFlow[i], r.heat[i], 1e-5 * heatScale);
    total += b.particles.force[i];
    heat += b.particles.heatFlow[i];
  }
  // momentum is conserved to rounding
  EXPECT_LT(length(total), (GetParam() == Precision::Single ? 1e-5 : 1e-13) * scale);
  EXPECT_LT(std::abs(heat), (GetParam() == Precision::Single ? 1e-5 : 1e-12) * heatScale);
  EXPECT_EQ(coincident, 0);
}

// A single liquid with uniform parameters reads less (terms/uniform_forces.hpp) and gives the same bits.
TEST_P(PairSumsTest, OneLiquidHasTheBitsOfTheGeneralCase) {
  for (const bool heat : {false, true}) {
    std::vector<Vec3d> force[2];
    std::vector<double> heatFlow[2], lost[2];
    for (const bool uniform : {false, true}) {
      Block b(9, 0.2, 2, GetParam());
      b.modules.heat = heat;
      b.modules.uniform = uniform;
      Continuum& p = b.particles;
      const std::size_t n = p.owned;
      for (std::size_t i = 0; i < n; i++)
        p.force[i] = {}, p.heatFlow[i] = p.dissipation[i] = p.interaction[i] = 0;
      b.findNeighbours(*pairKernels());
      std::int64_t coincident = 0;
      PairSums s = b.sums(&coincident);
      const double h = b.grid.support, dx = b.scene.spacing;
      const Material& m = b.scene.materials[0];
      s.heat = heat;
      s.uniform = uniform;
      s.volume = m.density * dx * dx * dx * (1 / (m.density * h * h * h));
      s.viscosity = s.conductivity = 1;
      pairKernels()->density(s, b.groups());
      packPressure({b.scene, b.modules, b.grid, b.liquids}, p, 0, n, b.records);
      pairKernels()->forces(s, b.groups());
      force[uniform].assign(p.force.data(), p.force.data() + n);
      lost[uniform].assign(p.dissipation.data(), p.dissipation.data() + n);
      if (heat) heatFlow[uniform].assign(p.heatFlow.data(), p.heatFlow.data() + n);
    }
    const auto equal = [](const auto& a, const auto& b) {
      return a.size() == b.size() &&
             (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
    };
    EXPECT_TRUE(equal(force[0], force[1])) << "heat " << heat;
    EXPECT_TRUE(equal(lost[0], lost[1])) << "heat " << heat;
    EXPECT_TRUE(equal(heatFlow[0], heatFlow[1])) << "heat " << heat;
  }
}
INSTANTIATE_TEST_SUITE_P(Precisions, PairSumsTest, testing::Values(Precision::Single, Precision::Double));

TEST(PairSums, AreTheSameBitsForEveryInstructionSet) {
  std::vector<float> relativeDensity[3];
  std::vector<Vec3d> force[3];
  int n = 0;
  for (const char* name : {"base", "avx2", "avx512"}) {
    const PairKernels* k = pairKernels(name);
    if (k == nullptr) continue;
    for (Precision precision : {Precision::Single, Precision::Double}) {
      Block b(9, 0.3, 2, precision);
      b.modules.contact = b.modules.tension = true;
      b.liquids[0].rootTension = 0.2;
      b.findNeighbours(*k);
      std::int64_t coincident = 0;
      PairSums s = b.sums(&coincident);
      k->density(s, b.groups());
      packPressure({b.scene, b.modules, b.grid, b.liquids}, b.particles, 0, b.particles.owned, b.records);
      k->forces(s, b.groups());
      k->tension(s, b.groups());
      relativeDensity[n].insert(relativeDensity[n].end(), b.particles.relativeDensity.data(),
                                b.particles.relativeDensity.data() + b.particles.owned);
      force[n].insert(force[n].end(), b.particles.force.data(), b.particles.force.data() + b.particles.owned);
    }
    if (n > 0) {
      EXPECT_EQ(std::memcmp(relativeDensity[0].data(), relativeDensity[n].data(),
                            relativeDensity[0].size() * sizeof(float)),
                0)
          << name;
      EXPECT_EQ(std::memcmp(force[0].data(), force[n].data(), force[0].size() * sizeof(Vec3d)), 0) << name;
    }
    n++;
  }
}

TEST(PairSums, CoincidentParticlesAreCountedAndMakeNoNaN) {
  Block b(6, 0.1);
  b.particles.position[20] = b.particles.position[21];
  b.findNeighbours(*pairKernels());
  std::int64_t coincident = 0;
  PairSums s = b.sums(&coincident);
  pairKernels()->density(s, b.groups());
  packPressure({b.scene, b.modules, b.grid, b.liquids}, b.particles, 0, b.particles.owned, b.records);
  pairKernels()->forces(s, b.groups());
  EXPECT_EQ(coincident, 2);
  for (std::size_t i = 0; i < b.particles.owned; i++)
    EXPECT_TRUE(std::isfinite(length(b.particles.force[i])));
}

// Cohesion: the force is the derivative of its energy, and the sums conserve momentum and angular momentum.
TEST(PairSums, TensionIsConservative) {
  Block b(6, 0.2, 2, Precision::Double);
  b.modules.tension = true;
  b.liquids[0].rootTension = 0.3;
  const auto energy = [&] {
    b.findNeighbours(*pairKernels());
    for (std::size_t i = 0; i < b.particles.owned; i++)
      b.particles.interaction[i] = 0, b.particles.force[i] = {};
    std::int64_t c = 0;
    pairKernels()->tension(b.sums(&c), b.groups());
    double e = 0;
    for (std::size_t i = 0; i < b.particles.owned; i++) e += b.particles.interaction[i];
    return e;
  };
  energy();
  const std::size_t row = 100;
  const Vec3d f = b.particles.force[row];
  Vec3d total{}, torque{};
  for (std::size_t i = 0; i < b.particles.owned; i++)
    total += b.particles.force[i], torque += cross(b.particles.position[i], b.particles.force[i]);
  EXPECT_LT(length(total), 1e-13 * length(f) * 200);
  EXPECT_LT(length(torque), 1e-13 * length(f) * 200);
  const double step = 1e-7;
  for (int a = 0; a < 3; a++) {
    b.particles.position[row][a] += step;
    const double up = energy();
    b.particles.position[row][a] -= 2 * step;
    const double down = energy();
    b.particles.position[row][a] += step;
    EXPECT_NEAR(-(up - down) / (2 * step), f[a], 1e-5 * length(f));
  }
}

}  // namespace thaw::test
