// SPDX-License-Identifier: Apache-2.0
// The correction of the pairwise viscosity is exact in any linear flow of any lattice. There is none at a
// free surface. It has the same bits with every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/fluid/laws/viscosity_factor.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "tests/support/lattice.hpp"

namespace thaw::test {
namespace {

/// Sums over a cubic lattice of two spacings to the support, whose layers along z have slid by `offset`
/// spacings along x. velocity: gradient of the velocity (1/s) times h.
ViscousNeighbours neighboursOf(double offset, const Mat3d& velocity) {
  ViscousNeighbours n;
  n.relativeDensity = 1;
  for (int k = -2; k <= 2; k++)
    for (int j = -2; j <= 2; j++)
      for (int i = -4; i <= 4; i++) {
        const Vec3d d = 0.5 * Vec3d{i + std::fmod(k * offset, 1.0), double(j), double(k)};
        const double q = length(d);
        if (q == 0 || q >= 1) continue;
        const double a = 0.125 * isa_base::weightAt(ViscousWeight{}.scale, q) / (q * q);
        const double p[6] = {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.x * d.z};
        const Vec3d u = velocity * d;
        for (int r = 0, at = 0; r < 6; r++) {
          n.second[r] += a * p[r];
          for (int s = r; s < 6; s++, at++) n.fourth[at] += a * p[r] * p[s];
        }
        for (int r = 0; r < 3; r++)
          for (int s = 0; s < 3; s++) n.velocity[3 * r + s] += a * u[r] * d[s];
      }
  return n;
}

/// Dissipation of the pairs over that of the liquid, 2 D:D.
double dissipationOf(double offset, const Mat3d& velocity) {
  const Sym3d D = symmetric(velocity);
  double pairs = 0;
  for (int k = -2; k <= 2; k++)
    for (int j = -2; j <= 2; j++)
      for (int i = -4; i <= 4; i++) {
        const Vec3d d = 0.5 * Vec3d{i + std::fmod(k * offset, 1.0), double(j), double(k)};
        const double q = length(d);
        if (q == 0 || q >= 1) continue;
        const double along = dot(d, full(D) * d);
        pairs += 0.5 * 0.125 * isa_base::weightAt(ViscousWeight{}.scale, q) * along * along / (q * q);
      }
  return pairs /
         (2 * (D.xx * D.xx + D.yy * D.yy + D.zz * D.zz) + 4 * (D.xy * D.xy + D.yz * D.yz + D.xz * D.xz));
}

const Mat3d shear{{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}}, stretch{{{1, 0, 0}, {0, 0, 0}, {0, 0, -1}}},
    skew{{{0.3, -2, 1}, {0.4, 0.5, 0.1}, {-0.7, 0.2, -0.8}}};

TEST(ViscosityCorrection, MakesLinearFlowsExact) {
  for (const Mat3d& flow : {shear, stretch, skew})
    for (const double offset : {0.0, 0.2, 0.37, 0.5, 0.8}) {
      const double without = dissipationOf(offset, flow);
      EXPECT_NEAR(viscosityFactor(neighboursOf(offset, flow), 10) * without, 1, 1e-12);
    }
  EXPECT_GT(std::abs(dissipationOf(0, stretch) - 1), 0.1);  // the lattice needs the correction
}

TEST(ViscosityCorrection, IgnoresRotationAndCompression) {
  const Mat3d spin{{{0, 0.5, 0}, {-0.5, 0, 0.1}, {0, -0.1, 0}}};
  const double factor = viscosityFactor(neighboursOf(0.2, skew), 10);
  EXPECT_NEAR(viscosityFactor(neighboursOf(0.2, skew + spin + 0.7 * identity3<double>()), 10), factor, 1e-12);
}

TEST(ViscosityCorrection, StaysWithinItsLimits) {
  ViscousNeighbours few = neighboursOf(0, stretch);
  EXPECT_NEAR(viscosityFactor(few, 1.05), 1.05, 1e-12);
  few.relativeDensity = 0.9;
  EXPECT_EQ(viscosityFactor(few, 10), 1);
  EXPECT_EQ(viscosityFactor(neighboursOf(0, Mat3d{}), 10), 1);
}

TEST(ViscosityCorrection, HasTheSameBitsWithEveryInstructionSet) {
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    Block block(7, 0.3, 2, precision);
    block.findNeighbours(*pairKernels("base"));
    std::int64_t coincident = 0;
    std::vector<float> first;
    for (const char* isa : {"base", "avx2", "avx512"}) {
      const PairKernels* kernels = pairKernels(isa);
      if (!kernels) continue;
      std::vector<float> result(block.particles.owned, 7);
      PairSums s = block.sums(&coincident);
      s.viscosityCorrection = result.data();
      s.largestViscosityFactor = 2;
      kernels->viscosityCorrection(s, block.groups());
      if (first.empty()) first = result;
      EXPECT_EQ(std::memcmp(first.data(), result.data(), 4 * result.size()), 0) << isa;
    }
    EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](float c) { return c != 0 && c < 1; }));
  }
}

}  // namespace
}  // namespace thaw::test
