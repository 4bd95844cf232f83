// SPDX-License-Identifier: Apache-2.0
#include "core/kernels/lattice.hpp"

#include <gtest/gtest.h>

namespace thaw::test {

// Stability limits of MCG03's Laplacian: viscous 0.118, heat 0.117 h^2.
TEST(Lattice, DiffusionStepsAreStableToTheKnownLimit) {
  Numerics n;
  n.conduction = Conduction::Plain;
  n.kernel = KernelKind::Mcg03;
  n.viscosity = ViscosityForm::Laplacian;
  n.support = 1.5;
  EXPECT_NEAR(stableViscousStep(n), 0.118, 0.001);
  EXPECT_NEAR(stableHeatStep(n), 0.118, 0.001);
  n.support = 2;
  EXPECT_NEAR(stableViscousStep(n), 0.1265, 0.001);
  n.viscosity = ViscosityForm::Pairwise;
  EXPECT_NEAR(stableViscousStep(n), 0.0442, 0.0005);
  n.kernel = KernelKind::WendlandC2;
  EXPECT_NEAR(stableHeatStep(n), 0.0778, 0.0005);
}

// The viscosity kernel's Laplacian on the lattice (docs/validation/accuracy.md).
TEST(Lattice, LaplacianOfAQuadraticFieldIsKnown) {
  Numerics n;
  n.kernel = KernelKind::Mcg03;
  for (const auto& [support, expected] :
       {std::pair{1.5, 1.060}, {2.0, 0.988}, {2.5, 1.021}, {3.0, 0.956}, {4.0, 1.008}}) {
    n.support = support;
    EXPECT_NEAR(latticeLaplacian(n), expected, 5e-4) << support;
    EXPECT_DOUBLE_EQ(conductionScale(n) * latticeLaplacian(n), 1);
  }
  const double normalised = stableHeatStep(n), scale = conductionScale(n);
  n.conduction = Conduction::Plain;
  EXPECT_EQ(conductionScale(n), 1);
  EXPECT_DOUBLE_EQ(stableHeatStep(n), normalised * scale);
}

// The scale of the weight, computed by independent sums. It is close to the continuum value for sliding
// layers, independent of the value of the lattice at rest.
TEST(Lattice, WeightOfTheViscosityIsCalibratedOnSlidingLayers) {
  Numerics n;
  n.support = 2;
  EXPECT_NEAR(viscousWeight(n).scale / ViscousWeight{}.scale, 1 / 0.994, 0.002);
  n.support = 2.5;
  EXPECT_NEAR(viscousWeight(n).scale / ViscousWeight{}.scale, 1 / 0.9625, 0.002);
  n.support = 3;
  EXPECT_NEAR(viscousWeight(n).scale / ViscousWeight{}.scale, 1 / 1.002, 0.002);
}

}  // namespace thaw::test
