// SPDX-License-Identifier: Apache-2.0
// Stresses of material laws against finite differences of their energies, and forces of a body against its
// energy.
#include <gtest/gtest.h>

#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/response.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

constexpr ElasticLaw allLaws[]{ElasticLaw::Green, ElasticLaw::NeoHookean, ElasticLaw::Corotated};

Mat3d noiseMatrix(std::uint64_t n, double size) {
  return size * Mat3d{{noise3(n, 1), noise3(n, 2), noise3(n, 3)}};
}

}  // namespace

TEST(Laws, StressIsDerivativeOfEnergy) {
  for (const ElasticLaw law : allLaws)
    for (std::uint64_t n = 0; n < 20; n++) {
      Material m = elasticMaterial(1.0, 0.3);
      m.law = law;
      m.volumeStiffness = 0.7;
      const ElasticConstants c = elasticConstants(m, 0);
      const Mat3d plastic{{{-0.05, 0.02, 0.03}, {-0.04, 0.01, -0.02}, {0.01, -0.03, 0.04}}};
      const Mat3d g = noiseMatrix(n, n < 15 ? 0.4 : 1.5);  // the last ones are far away or inverted
      const ElasticResponse r = elasticResponse(c, g, plastic);
      for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
          const double d = 1e-5;
          Mat3d up = g, down = g;
          up.row[i][k] += d;
          down.row[i][k] -= d;
          const double slope = (elasticResponse(c, up, plastic).energy -
                                elasticResponse(c, down, plastic).energy) /
                               (2 * d);
          EXPECT_NEAR(slope, r.stress.row[i][k], 1e-7 * (1 + largest(r.stress))) << int(law) << ' ' << n;
        }
    }
}

TEST(Laws, SmallStrainsFollowHooke) {
  const Mat3d g{{{1e-6, 2e-6, 0}, {0, -1e-6, 1e-6}, {2e-6, 0, 3e-6}}};
  for (const ElasticLaw law : allLaws) {
    Material m = elasticMaterial(2e6, 0.35);
    m.law = law;
    const double lambda = 2e6 * 0.35 / (1.35 * 0.3), mu = 2e6 / 2.7;
    const Sym3d e = symmetric(g);
    const Mat3d p = elasticResponse(elasticConstants(m, 0), g).stress;
    const Mat3d hookes = full(2 * mu * e) + (lambda * trace(e)) * identity3<double>();
    EXPECT_LT(largest(p - hookes), 1e-5 * largest(hookes)) << int(law);
  }
}

TEST(Laws, ObjectiveUnderRotation) {
  const Mat3d r = rotation({1, -2, 0.4}, 2.2), one = identity3<double>();
  for (const ElasticLaw law : allLaws) {
    Material m = elasticMaterial();
    m.law = law;
    const ElasticConstants c = elasticConstants(m, 0);
    const Mat3d f = one + noiseMatrix(3, 0.3);
    const ElasticResponse a = elasticResponse(c, f - one), b = elasticResponse(c, r * f - one);
    EXPECT_NEAR(a.energy, b.energy, 1e-12 * a.energy + 1e-9);
    EXPECT_LT(largest(r * a.stress - b.stress), 1e-12 * largest(a.stress));
  }
}

TEST(Laws, NearestRotationOfInvertedAndSingular) {
  const Mat3d r = rotation({0.3, 1, 2}, 0.7);
  for (const Vec3d d : {Vec3d{1.2, 0.9, 1.1}, Vec3d{1.5, 1, -0.4}, Vec3d{1, 1, 0}, Vec3d{2, 1, 1e-9}}) {
    const Mat3d s{{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}};
    EXPECT_LT(largest(nearestRotation(r * s) - r), 1e-12);
  }
  const Mat3d zero = nearestRotation(Mat3d{});
  EXPECT_NEAR(determinant(zero), 1, 1e-12);
}

// Eight lanes of several laws, some inverted: each lane's energy equals that of a single evaluation.
TEST(Laws, LanesOfAGroupDoNotDependOnEachOther) {
  const auto points = lattice({5, 3, 3}, 0.1, 0.2);
  for (const double yield : {never, 0.01}) {
    std::vector<Material> materials;
    for (const ElasticLaw law : allLaws) {
      Material m = elasticMaterial(1e4, 0.3);
      m.law = law;
      m.hourglass = 0;
      m.volumeStiffness = 5e3;
      m.yieldStrain = {yield, yield};
      m.creepRate = {20, 20};
      materials.push_back(m);
    }
    BodyOptions options;
    options.material = [](std::size_t i) { return static_cast<int>(i * i % 7 % 3); };
    const auto b = makeBody(points, materials, options);
    for (std::size_t s = 0; s < points.size(); s++)
      b->solids.position[s] = points[s] + (s % 3 == 0 ? 0.15 : 0.02) * noise3(s, 3);
    b->step.dt = 1e-3;
    const ElasticResult r = computeForces(*b);
    EXPECT_GT(r.inverted, 2);
    EXPECT_LT(r.inverted, 40);
    for (std::size_t s = 0; s < points.size(); s++) {
      const ElasticConstants c = elasticConstants(materials[b->solids.material[s]], 0);
      const Mat3d plastic = b->solids.plasticInverse.active ? b->solids.plasticInverse[s] : Mat3d{};
      const double alone = b->solids.volume[s] *
                           elasticResponse(c, b->solids.deformation[s] - identity3<double>(), plastic).energy;
      EXPECT_NEAR(b->solids.energy[s], alone, 1e-11 * (std::abs(alone) + 1)) << s;
    }
  }
}

TEST(Laws, ForcesAreDerivativesOfTotalEnergy) {
  const auto points = lattice({4, 3, 3}, 0.1, 0.2);
  for (const ElasticLaw law : allLaws)
    for (const bool freezing : {false, true}) {
      Material m = elasticMaterial(1e4, 0.3), other = elasticMaterial(3e4, 0.2);
      m.law = law;
      m.volumeStiffness = 5e3;
      m.hourglass = 0.8;
      BodyOptions options;
      options.freezing = freezing;
      options.material = [](std::size_t i) { return i % 4 == 1; };
      const auto b = makeBody(points, {m, other}, options);
      std::vector<Vec3d> moved;
      for (std::size_t s = 0; s < points.size(); s++) moved.push_back(points[s] + 0.012 * noise3(s, 3));
      moveAll(*b, moved, [](const Vec3d& x) { return x; });
      computeForces(*b);
      const std::vector<Vec3d> force(b->solids.force.data(), b->solids.force.data() + points.size());
      double scale = 0;
      for (const Vec3d& f : force) scale = std::max(scale, length(f));
      for (const std::size_t s : {0, 7, 13, 22, 35})
        for (int a = 0; a < 3; a++) {
          const double d = 1e-6;
          double energy[2];
          for (int side = 0; side < 2; side++) {
            b->solids.position[s] = moved[s];
            b->solids.position[s][a] += side == 0 ? -d : d;
            computeForces(*b);
            energy[side] = totalEnergy(*b);
          }
          b->solids.position[s] = moved[s];
          EXPECT_NEAR((energy[0] - energy[1]) / (2 * d), force[s][a], 2e-7 * scale)
              << int(law) << ' ' << freezing;
        }
    }
}
