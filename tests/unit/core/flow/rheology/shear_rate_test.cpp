// SPDX-License-Identifier: Apache-2.0
// The shear rate of particles: exact in linear flows, finite for few neighbours, the same bits with every
// instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/flow/rheology/shear_sums.hpp"
#include "tests/support/lattice.hpp"

namespace thaw::test {
namespace {

using Rows = std::vector<ShearMoments>;

void keep(void* context, std::uint32_t row, const ShearMoments& m) {
  (*static_cast<Rows*>(context))[row] = m;
}

/// Sums of all rows of a block.
Rows sumsOf(Block& b, const char* isa = "") {
  b.findNeighbours(*pairKernels(isa));
  std::int64_t coincident = 0;
  const PairSums in = b.sums(&coincident);
  Rows rows(b.particles.owned);
  shearKernels(isa)->sum(in, {&rows, keep}, {0, b.lists.groups});
  return rows;
}

void setFlow(Block& b, const Mat3d& gradient) {
  for (std::size_t i = 0; i < b.particles.owned; i++)
    b.particles.velocity[i] = gradient * b.particles.position[i];
}

}  // namespace

TEST(ShearRate, IsExactInLinearFlows) {
  const Mat3d skew{{{0.3, -2, 1}, {0.4, 0.5, 0.1}, {-0.7, 0.2, -0.8}}};
  const Sym3d D = symmetric(skew);
  const double exact = std::sqrt(2 * doubleDot(D, D));
  for (const double jitter : {0.0, 0.2})
    for (const Precision precision : {Precision::Single, Precision::Double}) {
      Block b(8, jitter, 2, precision);
      setFlow(b, skew);
      for (const ShearMoments& m : sumsOf(b))  // also at faces and corners of the block
        EXPECT_NEAR(shearRateOf(m) / b.grid.support, exact, 2e-3 * exact);
    }
}

TEST(ShearRate, RotationAndExpansionHaveNone) {
  for (const Mat3d& flow : {Mat3d{{{0, -1, 2}, {1, 0, 3}, {-2, -3, 0}}}, identity3<double>()}) {
    Block b(6, 0.2, 2, Precision::Double);
    setFlow(b, flow);
    for (const ShearMoments& m : sumsOf(b)) EXPECT_LT(shearRateOf(m) / b.grid.support, 5e-3);
  }
}

TEST(ShearRate, IsFiniteWithFewNeighbours) {
  ShearMoments m;
  EXPECT_EQ(shearRateOf(m), 0);
  m.moment[0] = 0.1;    // one neighbour along x
  m.velocity[3] = 0.1;  // it moves along y
  EXPECT_NEAR(shearRateOf(m), 1, 1e-4);
}

TEST(ShearRate, SolidsSeeOnlyLiquid) {
  Block b(6, 0.1);
  setFlow(b, {{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}});
  for (std::size_t i = 0; i < b.particles.owned; i++) b.particles.phase[i] = Solid, b.particles.liquid[i] = 0;
  for (const ShearMoments& m : sumsOf(b)) EXPECT_EQ(m.moment[0] + m.moment[1] + m.moment[2], 0);
}

TEST(ShearRate, SameBitsWithEveryInstructionSet) {
  Block b(7, 0.3);
  const Rows base = sumsOf(b, "base");
  for (const char* isa : {"avx2", "avx512"}) {
    if (!shearKernels(isa)) continue;
    const Rows other = sumsOf(b, isa);
    EXPECT_EQ(std::memcmp(base.data(), other.data(), base.size() * sizeof(ShearMoments)), 0) << isa;
  }
}

}  // namespace thaw::test
