// SPDX-License-Identifier: Apache-2.0
// Sliding lattice layers have a higher relative density than at rest with few neighbours, but not with more
// (incompressible solver).
#include <gtest/gtest.h>

#include "core/kernels/lattice.hpp"

namespace thaw {

TEST(SlidingLattice, HasAHigherDensityAtASupportOfTwo) {
  Numerics n;
  EXPECT_GT(slidingLatticeSum(n), 1.001 * latticeSum(n));
  EXPECT_LT(slidingLatticeSum(n), 1.01 * latticeSum(n));
  for (const KernelKind kernel : {KernelKind::WendlandC2, KernelKind::Mcg03, KernelKind::CubicSpline})
    for (const double support : {1.5, 2.0, 2.5, 3.0}) {
      n.kernel = kernel, n.support = support;
      EXPECT_GE(slidingLatticeSum(n), latticeSum(n));
    }
  n.kernel = KernelKind::WendlandC2, n.support = 2.5;
  EXPECT_LT(slidingLatticeSum(n), 1.0005 * latticeSum(n));
}

}  // namespace thaw
