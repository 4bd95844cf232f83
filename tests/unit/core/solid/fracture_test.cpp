// SPDX-License-Identifier: Apache-2.0
#include "core/solid/fracture.hpp"

#include <gtest/gtest.h>

#include "core/solid/elasticity/solid_state.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Intact bonds of a pair, counted from both ends.
std::int64_t bondsOf(const SolidBody& b, std::size_t i, std::size_t j) {
  std::int64_t n = 0;
  for (int k = 0; k < b.bonds.capacity; k++)
    n += b.bonds.hasBond(i, k) && b.bonds.neighbour[b.bonds.at(i, k)] == j;
  return n;
}

std::int64_t ends(const SolidBody& b) {
  std::int64_t n = 0;
  for (std::size_t i = 0; i < b.solids.owned; i++)
    for (int k = 0; k < b.bonds.capacity; k++) n += b.bonds.hasBond(i, k);
  return n;
}

}  // namespace

TEST(Fracture, BothEndsDecideEquallyAndTheLedgerClosesExactly) {
  const auto points = lattice({8, 4, 4}, 0.1, 0.2);
  for (const Precision precision : {Precision::Double, Precision::Single})
    for (const bool freezing : {false, true}) {
      Material tough = elasticMaterial(), brittle = elasticMaterial();
      tough.breakStretch = 1.6;
      brittle.breakStretch = 1.15;
      BodyOptions options;
      options.precision = precision;
      options.freezing = freezing;
      options.material = [](std::size_t i) { return i % 8 > 3; };
      const auto b = makeBody(points, {tough, brittle}, options);
      const std::int64_t before = ends(*b);
      moveAll(*b, points, [](const Vec3d& x) { return Vec3d{x.x * (1 + 0.4 * x.x), x.y, x.z}; });
      computeForces(*b);
      double energy = 0, after = 0;
      for (std::size_t s = 0; s < points.size(); s++) energy += solidEnergy(b->work, b->solids, b->bonds, s);
      ExactSum jump;
      const std::int64_t broken = breakBonds(b->work, b->solids, b->bonds, b->step, jump);
      EXPECT_GT(broken, 20);
      EXPECT_EQ(before - ends(*b), 2 * broken);
      for (std::size_t i = 0; i < points.size(); i++)
        for (std::size_t j = 0; j < i; j++) EXPECT_EQ(bondsOf(*b, i, j), bondsOf(*b, j, i));
      for (std::size_t s = 0; s < points.size(); s++) after += solidEnergy(b->work, b->solids, b->bonds, s);
      EXPECT_NEAR(energy - after, jump.value(), 1e-12 * energy);
      // phase 1 was repeated where bonds broke: forces are the derivative of the remaining energy
      computeElasticForces(b->work, b->solids, b->bonds, b->step, SolidPart::Inner);
      EXPECT_NEAR(totalEnergy(*b), after, (precision == Precision::Double ? 1e-12 : 1e-4) * after);
      Vec3d sum{};
      for (std::size_t s = 0; s < points.size(); s++) sum += b->solids.force[s];
      EXPECT_LT(length(sum), 1e-14 * forceScale(*b));
      computeForces(*b);
      EXPECT_EQ(breakBonds(b->work, b->solids, b->bonds, b->step, jump), 0);
    }
}

TEST(Fracture, UnstretchedBodyKeepsItsBonds) {
  const auto points = lattice({4, 4, 4}, 0.1, 0.2);
  Material m = elasticMaterial();
  m.breakStretch = 1.0001;
  const auto b = makeBody(points, {m});
  const Mat3d r = rotation({1, 1, 0.2}, 1.2);
  moveAll(*b, points, [&](const Vec3d& x) { return r * x; });
  computeForces(*b);
  ExactSum jump;
  EXPECT_EQ(breakBonds(b->work, b->solids, b->bonds, b->step, jump), 0);
  EXPECT_EQ(jump.value(), 0);
}

TEST(Fracture, BondsWithinTheContactDistanceStay) {
  const auto points = lattice({4, 4, 4}, 0.06);
  Material m = elasticMaterial();
  m.breakStretch = 1.25;
  const auto b = makeBody(points, {m});
  b->work.touch = 0.09;
  moveAll(*b, points, [](const Vec3d& x) { return Vec3d{1.4 * x.x, x.y, x.z}; });
  computeForces(*b);
  ExactSum jump;
  EXPECT_GT(breakBonds(b->work, b->solids, b->bonds, b->step, jump), 0);
  for (std::size_t i = 0; i < points.size(); i++)
    for (std::size_t j = 0; j < i; j++) {
      const Vec3d d = points[i] - points[j];
      if (std::abs(d.y) + std::abs(d.z) > 1e-9) continue;
      if (std::abs(d.x) < 0.07) EXPECT_GT(bondsOf(*b, i, j), 0);  // 0.084 apart: contact would repel
      else EXPECT_EQ(bondsOf(*b, i, j), 0);
    }
}

TEST(Fracture, BodyTornApartIsTwoFreePieces) {
  const auto points = lattice({6, 3, 3}, 0.1);
  Material m = elasticMaterial();
  m.breakStretch = 1.5;
  const auto b = makeBody(points, {m});
  moveAll(*b, points, [](const Vec3d& x) { return x.x > 0.25 ? x + Vec3d{1, 0, 0} : x; });
  computeForces(*b);
  ExactSum jump;
  EXPECT_GT(breakBonds(b->work, b->solids, b->bonds, b->step, jump), 0);
  computeForces(*b);
  EXPECT_LT(forceScale(*b), 1e-6);
  EXPECT_LT(totalEnergy(*b), 1e-9);
}
