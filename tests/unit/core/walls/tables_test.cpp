// SPDX-License-Identifier: Apache-2.0
// Wall tables against brute-force sums over finely sampled layers, and against the lattice half-space that
// they replace.
#include <gtest/gtest.h>

#include <cmath>

#include "core/kernels/kernels.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "core/walls/tables.hpp"

namespace thaw::test {
namespace {

using isa_base::CubicSpline;
using isa_base::Mcg03;
using isa_base::WendlandC2;

Numerics numericsOf(KernelKind kernel, double spacing) {
  Numerics n;
  n.kernel = kernel;
  n.conduction = Conduction::Plain;
  n.support = 1 / spacing;
  return n;
}

/// The same sums over squares of edge 1/n on each layer (support radius 1). `drag` is the pairwise viscosity
/// in the continuum's scale.
template<class Kernel> WallIntegrals bruteForce(double spacing, double d, int n) {
  WallIntegrals sum;
  const double a = 1.0 / n;
  for (double depth = 0.5 * spacing; d + depth < 1; depth += spacing)
    for (int i = 0; i < n; i++)
      for (int j = 0; j < n; j++) {
        // four quadrants
        const double x = (i + 0.5) * a, y = (j + 0.5) * a, z = d + depth, q2 = x * x + y * y + z * z,
                     V = 4 * a * a * spacing;
        if (q2 >= 1) continue;
        sum.relativeDensity += V * Kernel::w(q2);
        sum.push -= V * Kernel::slope(q2) * z;
        sum.conduct += V * Kernel::laplace(q2) * (1 + depth / std::max(d, 0.25 * spacing));
        sum.drag += V * isa_base::alongPair(ViscousWeight{}.scale, q2) * x * x / q2 *
                    (1 + depth / std::max(d, 0.25 * spacing));
      }
  return sum;
}

template<class Kernel> void expectTables(KernelKind kind) {
  for (double spacing : {0.5, 1 / 1.5, 1 / 3.0}) {
    const Numerics n = numericsOf(kind, spacing);
    const WallTables t = makeWallTables(n);
    const auto stress = [](const WallIntegrals& w, double d) { return w.drag * d; };
    for (const double d : {0.5 * spacing, 0.7 * spacing}) {  // the stress on both layers
      const double behind = d + spacing;
      if (behind >= 1) continue;
      const WallIntegrals near = bruteForce<Kernel>(spacing, d, 1500),
                          far = bruteForce<Kernel>(spacing, behind, 1500);
      EXPECT_NEAR(stress(wallIntegrals(n, behind), behind) / stress(wallIntegrals(n, d), d),
                  stress(far, behind) / stress(near, d), 1e-3);
    }
    for (double d : {-0.4 * spacing, 0.0, 0.1 * spacing, 0.5 * spacing, 0.6, 0.83}) {
      const WallIntegrals b = bruteForce<Kernel>(spacing, d, 1500),
                          e = wallIntegrals(numericsOf(kind, spacing), d), i = t(d);
      EXPECT_NEAR(e.relativeDensity, b.relativeDensity, 2e-5) << d;
      EXPECT_NEAR(e.push, b.push, 2e-4 * std::max(1.0, b.push)) << d;
      EXPECT_NEAR(e.conduct, b.conduct, 2e-4 * std::max(1.0, b.conduct)) << d;
      const double onLattice = wallIntegrals(numericsOf(kind, spacing), 0.5 * spacing).relativeDensity,
                   soft = std::max(d, softBelow * spacing);
      WallIntegrals liquid = forLiquids(wallIntegrals(numericsOf(kind, spacing), soft), onLattice);
      liquid.relativeDensity += liquid.push * (soft - d);
      EXPECT_NEAR(i.relativeDensity, liquid.relativeDensity, 2e-5 * std::max(1.0, liquid.relativeDensity))
          << d;
      EXPECT_NEAR(i.push, liquid.push, 3e-4 * std::max(1.0, liquid.push)) << d;
      EXPECT_NEAR(i.conduct, e.conduct, 1e-3 * std::max(1.0, e.conduct)) << d;
      EXPECT_NEAR(i.drag, e.drag, 1e-3 * std::max(1.0, e.drag)) << d;
    }
    EXPECT_EQ(t(1.0).relativeDensity, 0);
    EXPECT_EQ(t(-1.0).relativeDensity, t(t.lowest).relativeDensity);
  }
}

/// Sums over the lattice half-space at and above a particle half a spacing from a wall, and the wall's
/// contribution for the other half.
template<class Kernel> struct Half {
  double relativeDensity = 0, push = 0, full = 0, heat = 0;
  explicit Half(double spacing) {
    const int n = static_cast<int>(1 / spacing) + 1;
    const double V = spacing * spacing * spacing;
    for (int z = -n; z <= n; z++)
      for (int y = -n; y <= n; y++)
        for (int x = -n; x <= n; x++) {
          const double q2 = (x * x + y * y + z * z) * spacing * spacing;
          full += V * Kernel::w(q2);
          if (z < 0) continue;
          relativeDensity += V * Kernel::w(q2);
          if (q2 == 0) continue;
          push -= V * Kernel::slope(q2) * z * spacing;
          heat += V * Kernel::laplace(q2) * z * spacing;
        }
  }
};

}  // namespace

TEST(WallTables, AgreeWithFineSampling) {
  expectTables<WendlandC2>(KernelKind::WendlandC2);
  expectTables<CubicSpline>(KernelKind::CubicSpline);
  expectTables<Mcg03>(KernelKind::Mcg03);
}

TEST(WallTables, PushIsTheDerivativeOfTheDensity) {
  for (KernelKind kind : {KernelKind::WendlandC2, KernelKind::CubicSpline})
    for (double d : {0.05, 0.25, 0.5, 0.7}) {
      const double e = 1e-5, slope = (wallIntegrals(numericsOf(kind, 0.5), d - e).relativeDensity -
                                      wallIntegrals(numericsOf(kind, 0.5), d + e).relativeDensity) /
                                     (2 * e);
      EXPECT_NEAR(wallIntegrals(numericsOf(kind, 0.5), d).push, slope, 1e-6);
      const double onLattice = wallIntegrals(numericsOf(kind, 0.5), 0.25).relativeDensity;
      const auto liquid = [&](double x) {
        return forLiquids(wallIntegrals(numericsOf(kind, 0.5), x), onLattice);
      };
      EXPECT_NEAR(liquid(d).push, (liquid(d - e).relativeDensity - liquid(d + e).relativeDensity) / (2 * e),
                  1e-5 * std::max(1.0, liquid(d).push));
    }
}

// A particle half a spacing from a wall is hardly affected by the missing lattice.
TEST(WallTables, ReplaceTheMissingHalfOfTheLattice) {
  const double spacing = 0.5;
  const auto check = [&](auto kernel, KernelKind kind, double tolerance) {
    const Half<decltype(kernel)> half(spacing);
    const WallIntegrals w = wallIntegrals(numericsOf(kind, spacing), 0.5 * spacing);
    EXPECT_NEAR(half.relativeDensity + w.relativeDensity, half.full, tolerance * half.full);
    EXPECT_NEAR(w.push, half.push, 4 * tolerance * half.push);  // a uniform pressure has no force
    // a linear profile does not change
    EXPECT_NEAR(0.5 * spacing * w.conduct, half.heat, 4 * tolerance * half.heat);
  };
  check(WendlandC2{}, KernelKind::WendlandC2, 0.02);
  check(CubicSpline{}, KernelKind::CubicSpline, 0.02);
  check(Mcg03{}, KernelKind::Mcg03, 0.05);
}

// Layers at half a spacing and whole spacings above a wall have the shear stress of a linear profile.
TEST(WallTables, DragIsTheShearStress) {
  for (double support : {1.5, 2.0, 2.5, 3.0}) {
    const Numerics n = numericsOf(KernelKind::WendlandC2, 1 / support);
    double stress = 0;
    for (double d = 0.5 / support; d < 1; d += 1 / support) stress += wallIntegrals(n, d).drag * d / support;
    EXPECT_NEAR(stress, 1, 1e-12) << support;
  }
}

// In a linear profile the layers of a liquid bear the stress mu du/dz, wherever the first one lies. Otherwise
// liquid with a gap of half a spacing would slip.
TEST(WallTables, DragOfAllLayersIsTheShearStress) {
  for (const double support : {1.5, 2.0, 3.0})
    for (const double first : {0.01, 0.2, 0.4, 0.5, 0.6, 0.8, 0.96, 1.0}) {
      const double spacing = 1 / support;
      const WallTables t = makeWallTables(numericsOf(KernelKind::WendlandC2, spacing));
      double stress = 0;
      for (double d = first * spacing; d < 1; d += spacing) stress += spacing * t(d).drag * d;
      EXPECT_NEAR(stress, 1, first < 0.05 ? 0.02 : 2e-3) << support << " " << first;
    }
}

}  // namespace thaw::test
