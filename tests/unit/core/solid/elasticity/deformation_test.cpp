// SPDX-License-Identifier: Apache-2.0
// MLS gradient: exact for linear fields, invariant under rotation, finite in singular neighbourhoods.
#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "core/solid/elasticity/elastic_kernels.hpp"
#include "core/solid/elasticity/moment.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

double largestForce(const SolidBody& b) {
  double f = 0;
  for (std::size_t s = 0; s < b.solids.owned; s++) f = std::max(f, length(b.solids.force[s]));
  return f;
}

}  // namespace

TEST(Deformation, GradientIsExactOnAJitteredLattice) {
  const auto points = lattice({6, 5, 7}, 0.1, 0.25);
  const Mat3d g{{{0.1, -0.05, 0.2}, {0.07, -0.12, 0.03}, {-0.02, 0.15, 0.08}}};
  for (const Precision precision : {Precision::Double, Precision::Single}) {
    BodyOptions options;
    options.precision = precision;
    const auto b = makeBody(points, {elasticMaterial()}, options);
    moveAll(*b, points, [&](const Vec3d& x) { return x + g * x + Vec3d{3, -2, 1}; });
    const ElasticResult r = computeForces(*b);
    EXPECT_EQ(r.inverted, 0);
    for (std::size_t s = 0; s < b->solids.owned; s++)
      EXPECT_LT(largest(b->solids.deformation[s] - identity3<double>() - g),
                precision == Precision::Double ? 1e-12 : 5e-6)
          << s;
  }
}

TEST(Deformation, RigidRotationHasNoStrainNoForceNoEnergy) {
  const auto points = lattice({5, 5, 5}, 0.1, 0.2);
  for (const char* const law : {"green", "neo-hookean", "corotated"}) {
    Material m = elasticMaterial();
    m.law.name = law;
    m.volumeStiffness = 1e5;
    m.hourglass = 0.3;
    const auto b = makeBody(points, {m});
    // scale: the force of a strain of one
    const double scale = 1e6 * 0.1 * 0.1;
    for (int degrees = 0; degrees <= 360; degrees += 30) {
      const Mat3d r = rotation({1, 2, -0.5}, degrees * std::numbers::pi / 180);
      moveAll(*b, points, [&](const Vec3d& x) { return r * x + Vec3d{1, 2, 3}; });
      computeForces(*b);
      for (std::size_t s = 0; s < b->solids.owned; s++)
        EXPECT_LT(largest(b->solids.deformation[s] - r), 1e-12);
      EXPECT_LT(largestForce(*b), 1e-11 * scale);
      EXPECT_LT(totalEnergy(*b), 1e-12 * scale * 0.1 * 125);
    }
  }
}

TEST(Deformation, ConservesMomentumAndAngularMomentum) {
  const auto points = lattice({6, 5, 4}, 0.1, 0.2);
  for (const Precision precision : {Precision::Double, Precision::Single}) {
    Material soft = elasticMaterial(3e5, 0.4), hard = elasticMaterial(2e6, 0.1);
    hard.law.name = "neo-hookean";
    hard.damping = 5;
    BodyOptions options;
    options.precision = precision;
    options.volume = [](std::size_t i) { return 1e-3 * (1 + 0.5 * noise(i, 99)); };
    options.material = [](std::size_t i) { return i % 3 == 0; };
    const auto b = makeBody(points, {soft, hard}, options);
    for (std::size_t s = 0; s < points.size(); s++) {
      b->solids.position[s] = points[s] + 0.02 * noise3(s, 3);
      b->solids.velocity[s] = noise3(s, 5);
    }
    computeForces(*b);
    Vec3d sum{}, torque{};
    for (std::size_t s = 0; s < points.size(); s++) {
      sum += b->solids.force[s];
      torque += cross(b->solids.position[s], b->solids.force[s]);
    }
    const double scale = forceScale(*b);
    EXPECT_LT(length(sum), 1e-14 * scale);
    EXPECT_LT(length(torque), (precision == Precision::Double ? 1e-12 : 1e-6) * scale);
  }
}

TEST(Deformation, PeriodicSidesHaveNoEffectOnABody) {
  const auto points = lattice({6, 6, 6}, 0.1);
  for (const Precision precision : {Precision::Double, Precision::Single}) {
    BodyOptions options;
    options.precision = precision;
    options.period = {0.6, 0.6, 0.6};
    const auto b = makeBody(points, {elasticMaterial()}, options);
    EXPECT_EQ(b->bonds.capacity, 18);
    // moved by more than a fraction of the period and wrapped
    moveAll(*b, points, [&](const Vec3d& x) {
      Vec3d y = x + Vec3d{0.233, 0.411, 0.05};
      for (int a = 0; a < 3; a++) y[a] = y[a] >= 0.6 ? y[a] - 0.6 : y[a];
      return y;
    });
    computeForces(*b);
    for (std::size_t s = 0; s < points.size(); s++)
      EXPECT_LT(largest(b->solids.deformation[s] - identity3<double>()),
                precision == Precision::Double ? 1e-13 : 2e-6);
  }
}

/// A body across the periodic sides turns by half a turn, so that particles cross a side both ways.
TEST(Deformation, BodyAcrossPeriodicSidesTurnsFreely) {
  for (const Precision precision : {Precision::Double, Precision::Single}) {
    BodyOptions options;
    options.precision = precision;
    options.period = {0.9, 0.9, 0};
    const auto wrapped = [](Vec3d x) {
      for (int a = 0; a < 2; a++) x[a] -= 0.9 * std::floor(x[a] / 0.9);
      return x;
    };
    std::vector<Vec3d> points = lattice({6, 6, 3}, 0.1);
    const Vec3d middle{0.25, 0.25, 0.1};
    for (Vec3d& x : points) x = wrapped(x - middle);
    const auto b = makeBody(points, {elasticMaterial()}, options);
    for (const double angle : {0.7, 1.6, 3.14159, 4.4}) {
      const Mat3d turn = rotation({0, 0, 1}, angle);
      moveAll(*b, points, [&](const Vec3d& x) {
        const Vec3d from{x.x > 0.45 ? x.x - 0.9 : x.x, x.y > 0.45 ? x.y - 0.9 : x.y, x.z};
        return wrapped(turn * from);
      });
      computeForces(*b);
      for (std::size_t s = 0; s < points.size(); s++)
        EXPECT_LT(largest(b->solids.deformation[s] - turn), precision == Precision::Double ? 1e-13 : 2e-6)
            << angle;
    }
  }
}

TEST(Deformation, SingularNeighbourhoodsAreCountedAndStayFinite) {
  const auto count = [](SolidBody& b) { return refreshReference(b.work, b.solids, b.bonds, true); };
  // sheet: in-plane stretch and rotation
  const auto sheet = lattice({6, 6, 1}, 0.1);
  const auto b = makeBody(sheet, {elasticMaterial()});
  EXPECT_EQ(count(*b), 36);
  const Mat3d stretch{{{1.1, 0.05, 0}, {0, 0.95, 0}, {0, 0, 1}}}, r = rotation({1, 1, 0.3}, 1.1);
  moveAll(*b, sheet, [&](const Vec3d& x) { return r * (stretch * x); });
  computeForces(*b);
  for (std::size_t s = 0; s < 36; s++) EXPECT_LT(largest(b->solids.deformation[s] - r * stretch), 1e-12);
  // row
  const auto row = lattice({7, 1, 1}, 0.1);
  const auto c = makeBody(row, {elasticMaterial()});
  EXPECT_EQ(count(*c), 7);
  moveAll(*c, row, [&](const Vec3d& x) { return r * (1.2 * x); });
  computeForces(*c);
  for (std::size_t s = 0; s < 7; s++) {
    const Mat3d ftf = transpose(c->solids.deformation[s]) * c->solids.deformation[s];
    EXPECT_LT(largest(ftf - Mat3d{{{1.44, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), 1e-12);
  }
  // an isolated particle, and one with three neighbours
  const auto lonely = makeBody({{0, 0, 0}, {5, 0, 0}}, {elasticMaterial()});
  EXPECT_EQ(lonely->bonds.capacity, 0);
  EXPECT_EQ(count(*lonely), 2);
  computeForces(*lonely);
  EXPECT_EQ(largestForce(*lonely), 0);
  const std::vector<Vec3d> three{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  BodyOptions shortSupport;
  shortSupport.support = 1.3;
  const auto d = makeBody(three, {elasticMaterial()}, shortSupport);
  EXPECT_EQ(count(*d), 3);  // the corner has three directions, the others one
  moveAll(*d, three, [&](const Vec3d& x) { return r * x; });
  computeForces(*d);
  EXPECT_LT(largestForce(*d), 1e-8);
}

TEST(Deformation, InversionIsCountedAndUndone) {
  const auto points = lattice({4, 4, 4}, 0.1);
  for (const char* const law : {"green", "neo-hookean", "corotated"}) {
    Material m = elasticMaterial();
    m.law.name = law;
    const auto b = makeBody(points, {m});
    moveAll(*b, points, [](const Vec3d& x) { return Vec3d{-x.x, x.y, x.z}; });
    EXPECT_EQ(computeForces(*b).inverted, 64);
    if (std::string_view(law) == "green")
      EXPECT_LT(totalEnergy(*b), 1e-9);  // the papers' law does not detect inversion
    else EXPECT_GT(totalEnergy(*b), 1e3);
  }
}

TEST(Deformation, SameBitsForEveryInstructionSet) {
  const auto points = lattice({5, 6, 7}, 0.1, 0.2);
  for (const Precision precision : {Precision::Double, Precision::Single})
    for (const char* const law : {"green", "neo-hookean", "corotated"}) {
      BodyOptions options;
      options.precision = precision;
      Material m = elasticMaterial();
      m.law.name = law;
      std::vector<Vec3d> first;
      for (const char* isa : {"base", "avx2", "avx512"}) {
        const ElasticKernels* kernels = elasticKernels(isa);
        if (!kernels) continue;
        EXPECT_STREQ(kernels->name, isa);
        const auto b = makeBody(points, {m}, options);
        b->work.kernels = kernels;
        for (std::size_t s = 0; s < points.size(); s++)
          b->solids.position[s] = points[s] + (s % 30 == 0 ? 0.2 : 0.02) * noise3(s, 3);
        EXPECT_GT(computeForces(*b).inverted, 0);
        std::vector<Vec3d> forces(b->solids.force.data(), b->solids.force.data() + points.size());
        if (first.empty()) first = forces;
        EXPECT_TRUE(first == forces) << isa << ' ' << law;
      }
    }
}

TEST(Moment, CompletionKeepsHandedness) {
  const MomentInverse m = invertMoment({1, 1, 0, 0, 0, 0});
  EXPECT_EQ(m.rank, 2);
  const Mat3d f = completeGradient(Mat3d{}, m.inverse, 2);
  EXPECT_LT(largest(f), 1e-15);
  EXPECT_EQ(invertMoment({1, 1, 1e-4, 0, 0, 0}).rank, 2);
  EXPECT_EQ(invertMoment({1, 1, 0.05, 0, 0, 0}).rank, 3);
  EXPECT_EQ(invertMoment({}).rank, 0);
}

// Bodies at rest in their reference need no pass over the bonds at the start: the same bits.
TEST(Deformation, ShortcutAtTheReferenceHasTheSameBits) {
  auto points = lattice({5, 4, 5}, 0.1, 0.2);
  points.push_back({2, 0, 0});  // isolated
  points.push_back({3, 0, 0});  // a row of two
  points.push_back({3.1, 0, 0.02});
  for (const char* const law : {"green", "neo-hookean", "corotated"}) {
    Material m = elasticMaterial();
    m.law.name = law;
    const auto b = makeBody(points, {m});
    computeForces(*b);
    ASSERT_TRUE(atReference(b->solids));
    for (std::size_t s = 0; s < b->solids.owned; s++) {
      const SolidStrain bonds = solidStrain(b->work, b->solids, b->bonds, s),
                        none = solidStrainAtReference(b->work, b->solids, b->bonds, s);
      EXPECT_EQ(std::memcmp(&bonds, &none, sizeof bonds), 0) << s;
    }
    b->solids.position[7].x += 1e-9;
    EXPECT_FALSE(atReference(b->solids));
  }
}
