// SPDX-License-Identifier: Apache-2.0
// Forces and torques against finite differences of the energy, and the zeros of the four potentials.
#include "core/oriented/laws/pair_potential.hpp"

#include <gtest/gtest.h>

#include "core/math/hash_random.hpp"
#include "core/math/quat.hpp"
#include "core/oriented/laws/crease_pair.hpp"

namespace thaw {
namespace {

double random(int k) { return 2 * randomUniform(5, Purpose::Test, static_cast<std::uint64_t>(k)) - 1; }
Vec3d randomVector(int k) { return {random(3 * k), random(3 * k + 1), random(3 * k + 2)}; }

OrientedBody bodyOf(double attract, double plane, double normal, double circle) {
  OrientedBody b;
  b.attract = attract;
  b.plane = plane;
  b.normal = normal;
  b.circle = circle;
  return b;
}

TEST(PairPotential, ForcesAndTorquesAreDerivativesOfTheEnergy) {
  for (const bool facing : {true, false})
    for (int which = 0; which < 5; which++) {
      OrientedBody body = bodyOf(which == 0 || which == 4, which == 1 || which == 4, which == 2 || which == 4,
                                 which == 3 || which == 4);
      body.facing = facing;
      const PairPotential p = pairPotential(body, 0.7);
      double worst = 0, worstTorque = 0, scale = 0;
      for (int k = 0; k < 200; k++) {
        const Vec3d r = (0.5 + 1.6 * randomUniform(6, Purpose::Test, static_cast<std::uint64_t>(k))) *
                        normalized(randomVector(k + 1000 * which + 1));
        const Vec3d ni = normalized(randomVector(k + 7000));
        const Vec3d nj = normalized(ni + 0.9 * randomVector(k + 9000));
        const PairResult f = pairForces(p, r, ni, nj), back = pairForces(p, -r, nj, ni);
        EXPECT_NEAR(f.energy, back.energy, 1e-13 * (1 + std::abs(f.energy)));
        EXPECT_NEAR(length(f.force + back.force), 0, 1e-12 * (1 + length(f.force)));
        // angular momentum: sum of torques and of r x F
        EXPECT_NEAR(length(f.torque + back.torque + cross(r, back.force)), 0, 1e-11 * (1 + length(f.force)));
        const double h = 1e-6;
        for (int a = 0; a < 3; a++) {
          Vec3d d{};
          d[a] = h;
          // = dE/dx_j = -F_j = F_i
          const double byPlace = (pairForces(p, r + d, ni, nj).energy - pairForces(p, r - d, ni, nj).energy) /
                                 (2 * h);
          const double byTurn = (pairForces(p, r, rotated(rotationBy(d), ni), nj).energy -
                                 pairForces(p, r, rotated(rotationBy(-d), ni), nj).energy) /
                                (2 * h);
          worst = std::max(worst, std::abs(byPlace - f.force[a]));
          worstTorque = std::max(worstTorque, std::abs(byTurn + f.torque[a]));
          scale = std::max({scale, std::abs(byPlace), std::abs(byTurn)});
        }
      }
      EXPECT_LT(worst, 2e-8 * scale) << which;
      EXPECT_LT(worstTorque, 2e-8 * scale) << which;
      EXPECT_GT(scale, 0);
    }
}

TEST(CreasedPair, ForcesAndTorquesAreDerivativesOfTheEnergy) {
  const PairPotential p = pairPotential(OrientedBody{}, 0.7);
  for (int k = 0; k < 300; k++) {
    const Vec3d r = (0.5 + 1.6 * randomUniform(6, Purpose::Test, static_cast<std::uint64_t>(k))) *
                    normalized(randomVector(k + 1));
    const Vec3d ni = normalized(randomVector(k + 7000)), nj = normalized(randomVector(k + 9000));
    const bool a = k % 3 != 0, b = k % 3 != 1;
    const PairResult f = creasedPair(p, r, ni, nj, a, b), back = creasedPair(p, -r, nj, ni, b, a);
    EXPECT_NEAR(length(f.force + back.force), 0, 1e-12 * (1 + length(f.force)));
    EXPECT_NEAR(length(f.torque + back.torque + cross(r, back.force)), 0, 1e-11 * (1 + length(f.force)));
    const double h = 1e-6;
    for (int c = 0; c < 3; c++) {
      Vec3d d{};
      d[c] = h;
      EXPECT_NEAR(
          (creasedPair(p, r + d, ni, nj, a, b).energy - creasedPair(p, r - d, ni, nj, a, b).energy) / (2 * h),
          f.force[c], 1e-6 * (1 + length(f.force)));
      EXPECT_NEAR((creasedPair(p, r, rotated(rotationBy(d), ni), nj, a, b).energy -
                   creasedPair(p, r, rotated(rotationBy(-d), ni), nj, a, b).energy) /
                      (2 * h),
                  -f.torque[c], 1e-6 * (1 + length(f.torque)));
    }
  }
}

TEST(PairPotential, CloseParticlesHaveABoundedForce) {  // stability row 33
  const PairPotential p = pairPotential(OrientedBody{}, 1);
  const double atCore = length(pairForces(p, {p.core, 0, 0}, {0, 0, 1}, {0, 0, 1}).force);
  for (const double r : {0.5, 0.1, 1e-3, 1e-9}) {
    const PairResult f = pairForces(p, {r, 0, 0}, {0, 0, 1}, {0, 0, 1});
    EXPECT_TRUE(std::isfinite(f.energy));
    EXPECT_NEAR(length(f.force), atCore, 1e-9 * atCore);
    EXPECT_LT(f.force.x, 0);
  }
}

TEST(PairPotential, OppositeSidesDoNotAct) {  // stability row 33
  const PairPotential p = pairPotential(OrientedBody{}, 1);
  const PairResult f = pairForces(p, {0.2, 0, 0.8}, {0, 0, 1}, {0.3, 0, -0.95});
  EXPECT_EQ(f.energy, 0);
  EXPECT_EQ(length(f.force), 0);
}

TEST(PairPotential, PlaneAndSphereHaveNoEnergyOfTheirOwn) {
  for (int k = 0; k < 100; k++) {
    const Vec3d n = normalized(randomVector(k)), u = normalized(cross(n, randomVector(k + 500)));
    const double angle = 0.1 + 0.6 * std::abs(random(k + 800));
    // on a plane: co-planarity, co-normality and co-circularity
    EXPECT_NEAR(pairForces(pairPotential(bodyOf(0, 1, 1, 1), 1), 1.1 * u, n, n).energy, 0, 1e-12);
    // on a sphere: co-circularity, exactly
    const Vec3d m = std::cos(angle) * n + std::sin(angle) * u;
    EXPECT_NEAR(pairForces(pairPotential(bodyOf(0, 0, 0, 1), 1), 2.0 * (m - n), n, m).energy, 0, 1e-12);
    EXPECT_GT(pairForces(pairPotential(bodyOf(0, 1, 0, 0), 1), 2.0 * (m - n), n, m).energy, 1e-6);
  }
}

TEST(PairPotential, HexagonalLatticeIsAtRestAtTheSpacing) {
  for (const double support : {2.5, 3.0, 8.0}) {
    OrientedBody body;
    body.support = support;
    const PairPotential p = pairPotential(body, 0.02);
    EXPECT_NEAR(hexagonalEnergy(p, 0.02).slope, 0, 1e-12 * p.scale / 0.02);
    const double h = 1e-8;
    EXPECT_NEAR((hexagonalEnergy(p, 0.021 + h).energy - hexagonalEnergy(p, 0.021 - h).energy) / (2 * h),
                hexagonalEnergy(p, 0.021).slope, 1e-5 * p.scale / 0.02);
  }
}

TEST(PairPotential, FullSumOfLennardJonesRestsAtTheKnownSpacing) {  // 1.11146 sigma,
                                                                    // docs/validation/accuracy.md
  OrientedBody body;
  body.support = 60;
  const PairPotential p = pairPotential(body, 1);
  const double sigma = p.well / std::pow(2.0, 1.0 / 6);
  EXPECT_NEAR(1 / sigma, 1.11146, 1e-5);
}

}  // namespace
}  // namespace thaw
