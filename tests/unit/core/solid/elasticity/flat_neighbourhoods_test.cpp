// SPDX-License-Identifier: Apache-2.0
// Nearly flat or nearly linear neighbourhoods, as in frozen fragments: forces are the derivative of the
// energy and conserve momentum and angular momentum.
#include <gtest/gtest.h>

#include "tests/support/solid_body.hpp"

namespace thaw::test {
namespace {

/// A crumpled layer: neighbours lie off its plane by less than a tenth of their distance.
std::vector<Vec3d> layer(std::uint64_t salt) {
  std::vector<Vec3d> points = lattice({4, 4, 1}, 0.1);
  for (std::size_t k = 0; k < points.size(); k++) {
    const Vec3d x = noise3(k, salt);
    points[k] += Vec3d{0.02 * x.x, 0.02 * x.y, 0.005 * x.z};
  }
  return points;
}

/// Largest difference between forces and central differences of the energy, over the largest force.
double mismatch(SolidBody& b) {
  computeForces(b);
  const std::size_t n = b.solids.owned;
  std::vector<Vec3d> force(b.solids.force.data(), b.solids.force.data() + n);
  double worst = 0, largest = 0;
  for (std::size_t s = 0; s < n; s++)
    for (int axis = 0; axis < 3; axis++) {
      constexpr double h = 1e-6;
      double energy[2];
      for (int side = 0; side < 2; side++) {
        b.solids.position[s][axis] += side ? h : -h;
        computeForces(b);
        energy[side] = totalEnergy(b);
        b.solids.position[s][axis] -= side ? h : -h;
      }
      worst = std::max(worst, std::abs(force[s][axis] + (energy[1] - energy[0]) / (2 * h)));
      largest = std::max(largest, std::abs(force[s][axis]));
    }
  computeForces(b);
  return worst / largest;
}

void expectNoForceAndNoTurn(const SolidBody& b) {
  Vec3d force{}, torque{};
  for (std::size_t s = 0; s < b.solids.owned; s++) {
    force += b.solids.force[s];
    torque += cross(b.solids.position[s], b.solids.force[s]);
  }
  EXPECT_LT(length(force), 1e-11 * forceScale(b));
  EXPECT_LT(length(torque), 1e-11 * forceScale(b));
}

TEST(FlatNeighbourhoods, ForcesOfALayerAreTheDerivativeOfItsEnergy) {
  for (const char* const law : {"green", "neo-hookean", "corotated"}) {
    Material m = elasticMaterial();
    m.law.name = law;
    const std::vector<Vec3d> points = layer(1);
    const auto b = makeBody(points, {m});
    ASSERT_EQ(countSingular(b->work, b->solids), 16);
    const Mat3d r = rotation({1, 2, -0.5}, 1.3);
    // stretched, twisted, turned
    moveAll(*b, points, [&](const Vec3d& x) {
      return r * (x + Vec3d{0.1 * x.y, 0.05 * x.x, 1.5 * x.x * x.y});
    });
    EXPECT_LT(mismatch(*b), 1e-5);
    expectNoForceAndNoTurn(*b);
  }
}

TEST(FlatNeighbourhoods, ForcesOfAPlasticLayerAreTheDerivativeOfItsEnergy) {
  Material m = elasticMaterial();
  m.yieldStrain = {1e3, 1e3};  // no plastic flow here
  const std::vector<Vec3d> points = layer(2);
  const auto b = makeBody(points, {m});
  // with plastic shear across the plane
  for (std::size_t s = 0; s < b->solids.owned; s++)
    b->solids.plasticInverse[s] = {{{0.02, 0.005, -0.015}, {0.005, -0.01, 0.02}, {-0.015, 0.02, -0.01}}};
  moveAll(*b, points, [&](const Vec3d& x) { return x + Vec3d{0.1 * x.y, 0.05 * x.x, 1.5 * x.x * x.y}; });
  EXPECT_LT(mismatch(*b), 1e-5);
}

TEST(FlatNeighbourhoods, BentRowTurnsFreely) {
  std::vector<Vec3d> points;
  for (std::size_t k = 0; k < 6; k++)
    points.push_back(Vec3d{0.1 * static_cast<double>(k), 0, 0} + 0.003 * noise3(k, 3));
  const auto b = makeBody(points, {elasticMaterial()});
  ASSERT_EQ(countSingular(b->work, b->solids), 6);
  const Mat3d about = rotation({1, 0, 0}, 2.0), r = rotation({1, 2, -0.5}, 1.3);
  moveAll(*b, points, [&](const Vec3d& x) { return r * (about * x); });
  computeForces(*b);
  EXPECT_LT(forceScale(*b), 1e-6);  // N; a strain of one gives 1e4
  moveAll(*b, points, [&](const Vec3d& x) {
    return r * (about * Vec3d{1.1 * x.x, x.y, x.z + 0.3 * x.x * x.x});
  });
  EXPECT_LT(mismatch(*b), 1e-5);
  expectNoForceAndNoTurn(*b);
}

}  // namespace
}  // namespace thaw::test
