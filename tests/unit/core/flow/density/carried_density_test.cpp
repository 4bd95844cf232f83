// SPDX-License-Identifier: Apache-2.0
// The step of carried densities (core/fluid/terms/carry.hpp).
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

/// Liquid in the corner of two walls with a free surface, and (solid) a soft cube in it.
Scene liquidInACorner(bool solid) {
  const double spacing = 0.1;
  Scene s = test::emptyScene(spacing, {0, 0, 0}, {2, 1, 2});
  s.domain.side[0][0] = s.domain.side[2][0] = Side::Wall;
  s.domain.gravity = {0, 0, -9.81};
  s.materials.resize(solid ? 2 : 1);
  s.materials[0].name = "water";
  s.materials[0].viscosity = {1, 1};
  s.materials[0].soundSpeed = 30;
  test::carryDensity(s, 0.2);
  s.numerics.overlap = OverlapRule::RemoveLater;
  if (solid) {
    s.materials[1].name = "rubber";
    s.materials[1].young = {1e5, 0};
    test::addBox(s, {0.2, 0.3, 0.2}, {0.6, 0.7, 0.6}).material = 1;
  }
  test::addBox(s, {0, 0, 0}, {1, 1, 0.8}).material = 0;
  s.bodies.back().velocity = {-0.5, 0.2, -0.3};
  s.end = 1;
  return s;
}

template<class T> bool equalColumns(const Column<T>& a, const Column<T>& b, std::size_t rows) {
  return a.active == b.active && (!a.active || std::memcmp(a.data(), b.data(), rows * sizeof(T)) == 0);
}

TEST(CarriedDensity, AllInstructionSetsGiveTheSameBits) {
  for (const bool solid : {false, true})
    for (const Precision precision : {Precision::Single, Precision::Double}) {
      Scene s = liquidInACorner(solid);
      s.numerics.precision = precision;
      Simulation base(s);
      base.tools.sums.kernels = pairKernels("base");
      for (int k = 0; k < 5; k++) ASSERT_TRUE(base.step());
      for (const char* name : {"avx2", "avx512"}) {
        if (!pairKernels(name)) continue;
        Simulation other(s);
        other.tools.sums.kernels = pairKernels(name);
        for (int k = 0; k < 5; k++) ASSERT_TRUE(other.step());
        const Continuum &p = base.particles(), &q = other.particles();
        ASSERT_EQ(p.owned, q.owned);
        EXPECT_TRUE(equalColumns(p.compression, q.compression, p.owned)) << name;
        EXPECT_TRUE(equalColumns(p.midCorrection, q.midCorrection, p.owned)) << name;
        EXPECT_TRUE(equalColumns(p.shiftingVelocity, q.shiftingVelocity, p.owned)) << name;
        EXPECT_TRUE(equalColumns(p.dissipated, q.dissipated, p.owned)) << name;
        EXPECT_TRUE(equalColumns(p.velocity, q.velocity, p.owned)) << name;
      }
    }
}

}  // namespace
}  // namespace thaw
