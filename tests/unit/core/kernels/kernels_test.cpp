// SPDX-License-Identifier: Apache-2.0
#include "core/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thaw {
namespace {

template<class Kernel> class Kernels : public testing::Test {};
using All = testing::Types<isa_base::WendlandC2, isa_base::Mcg03, isa_base::CubicSpline>;
TYPED_TEST_SUITE(Kernels, All);

TYPED_TEST(Kernels, IntegrateToOneIn3D) {
  const int n = 20000;
  double volume = 0, gradient = 0, laplacian = 0;
  for (int k = 0; k < n; k++) {  // midpoint rule over the radius
    const double q = (k + 0.5) / n, shell = 4 * std::numbers::pi * q * q / n;
    volume += shell * TypeParam::w(q * q);
    gradient -= shell * TypeParam::slope(q * q) * q * q / 3;     // int -x dW/dx = int W = 1
    laplacian += shell * TypeParam::laplace(q * q) * q * q / 6;  // int x^2/2 lap W = 1
  }
  EXPECT_NEAR(volume, 1, 1e-6);
  EXPECT_NEAR(gradient, 1, 1e-6);
  EXPECT_NEAR(laplacian, 1, 1e-6);
}

TYPED_TEST(Kernels, VanishAtTheSupportAndBeyond) {
  for (double q : {1.0, 1.0001, 1.5, 1000.0}) {
    EXPECT_EQ(TypeParam::w(q * q), 0);
    EXPECT_EQ(TypeParam::slope(q * q), 0);
    EXPECT_EQ(TypeParam::laplace(q * q), 0);
  }
}

/// Sums over a simple cubic lattice with spacing ratio h / dx: rho / rho0, first derivative of x, second
/// derivative of x^2 / 2.
template<class Kernel> void latticeOperators(double ratio, double out[3]) {
  const int n = static_cast<int>(ratio) + 1;
  out[0] = out[1] = out[2] = 0;
  for (int x = -n; x <= n; x++)
    for (int y = -n; y <= n; y++)
      for (int z = -n; z <= n; z++) {
        const double q2 = (x * x + y * y + z * z) / (ratio * ratio), V = 1 / (ratio * ratio * ratio),
                     X = x / ratio;
        out[0] += V * Kernel::w(q2);
        out[1] -= V * Kernel::slope(q2) * X * X;
        out[2] += V * Kernel::laplace(q2) * X * X / 2;
      }
}

// Values of MCG03's kernels on the simple cubic lattice to four digits, computed independently with numpy.
TEST(Lattice, OperatorsHaveTheKnownErrors) {
  const double ratio[] = {1.5, 2, 2.5, 3, 4};
  const double known[][5] = {{.9494, 1.0098, .9954, 1.0022, 1.0000},
                             {.6811, .9563, .9498, .9896, .9972},
                             {1.0603, .9881, 1.0212, .9559, 1.0080}};
  for (int k = 0; k < 5; k++) {
    double o[3];
    latticeOperators<isa_base::Mcg03>(ratio[k], o);
    for (int m = 0; m < 3; m++)
      EXPECT_NEAR(o[m], known[m][k], 1e-4) << "h/dx " << ratio[k] << ", operator " << m;
  }
}

}  // namespace
}  // namespace thaw
