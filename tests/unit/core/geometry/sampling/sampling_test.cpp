// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/sampling.hpp"

#include <gtest/gtest.h>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/bust.hpp"
#include "core/geometry/shapes/mesh_distance.hpp"
#include "core/geometry/shapes/primitives.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/samples.hpp"

namespace thaw {
namespace {

TEST(Sampling, BoxesAreFilledExactly) {
  for (const int n : {1, 2, 7, 30}) {
    Shape s;
    const double spacing = 0.013;
    s.size = {n * spacing, n * spacing, n * spacing};
    s.move = {0.1, -0.7, 33.3};
    const auto d = makeSignedDistance(s);
    const SampleLattice l = sampleLattice(*d, spacing);
    const Samples p = sampleShape(*d, l, {0, l.rows()});
    ASSERT_EQ(p.position.size(), static_cast<std::size_t>(n * n * n));
    EXPECT_NEAR(p.position[0].x - d->bounds().min.x, 0.5 * spacing, 1e-12);
    EXPECT_EQ(countSamples(*d, l, {0, l.rows()}), n * n * n);
  }
}

TEST(Sampling, TurnedLatticesFollowTheRotationOfTheirShape) {
  Shape s;
  s.size = {1, 0.7, 0.4};
  s.rotate = {0.4, -0.7, 1.9};
  s.move = {0.1, -0.7, 33.3};
  const auto d = makeSignedDistance(s);
  for (const Layers layers : {Layers::Cover, Layers::Fit}) {
    const SampleLattice l = turnedLattice(*d, 0.1, layers);
    const Samples p = sampleShape(*d, l, {0, l.rows()});
    ASSERT_EQ(p.position.size(), 280u);
    for (const Vec3d& x : p.position) EXPECT_LT(d->distance(x), -0.0499);
  }
}

TEST(Sampling, DoesNotDependOnTheNumberOfRanks) {
  const MeshDistance d(bustMesh(), "bust");
  const SampleLattice l = sampleLattice(d, 0.025);
  const Samples all = sampleShape(d, l, {0, l.rows()});
  ASSERT_GT(all.number.size(), 2000u);
  for (std::size_t k = 1; k < all.number.size(); k++) ASSERT_LT(all.number[k - 1], all.number[k]);
  for (const int ranks : {2, 3, 7, 10000}) {
    Samples joined;
    std::int64_t end = 0;
    for (int r = 0; r < ranks; r++) {
      const SampleRange range = sampleRange(l, r, ranks);
      ASSERT_EQ(range.begin, end);
      end = range.end;
      const Samples part = sampleShape(d, l, range);
      joined.position.insert(joined.position.end(), part.position.begin(), part.position.end());
      joined.number.insert(joined.number.end(), part.number.begin(), part.number.end());
    }
    EXPECT_EQ(end, l.rows());
    EXPECT_EQ(joined.number, all.number);
    EXPECT_EQ(joined.position, all.position);
  }
}

TEST(Sampling, SkippingFindsAllSamples) {
  Shape ball, bite;
  ball.kind = bite.kind = ShapeKind::Sphere;
  ball.radius = 0.5, bite.radius = 0.3, bite.move = {0.5, 0, 0};
  Shape s;
  s.kind = ShapeKind::Difference;
  s.parts = {ball, bite};
  Shape bust;
  bust.kind = ShapeKind::Mesh;
  bust.mesh = "builtin:bust";
  bust.rotate = {0.3, 0.4, 0.5};
  for (const Shape& shape : {s, bust}) {
    const auto d = makeSignedDistance(shape);
    const SampleLattice l = sampleLattice(*d, 0.03);
    const Samples p = sampleShape(*d, l, {0, l.rows()});
    std::size_t found = 0;
    for (std::int64_t k = 0; k < l.count[2]; k++)
      for (std::int64_t j = 0; j < l.count[1]; j++)
        for (std::int64_t i = 0; i < l.count[0]; i++) {
          if (!d->inside(l.at(i, j, k))) continue;
          ASSERT_LT(found, p.number.size());
          ASSERT_EQ(p.number[found], static_cast<std::uint64_t>(i + l.count[0] * (j + l.count[1] * k)));
          ASSERT_EQ(p.position[found], l.at(i, j, k));
          found++;
        }
    EXPECT_EQ(found, p.number.size());
  }
}

TEST(Sampling, VolumesAreExact) {
  const double r = 0.5, s = 0.02;
  const auto n = static_cast<double>(
      countSamples(SphereDistance(r), sampleLattice(SphereDistance(r), s), {0, 2500}));
  EXPECT_NEAR(n * s * s * s, 4.18879 * r * r * r, 0.01);
}

TEST(Sampling, RefusesUnboundedShapes) {
  EXPECT_THROW(sampleLattice(HalfSpaceDistance({}, {0, 0, 1}), 0.1), ShapeError);
  EXPECT_THROW(sampleLattice(SphereDistance(1), 1e-5), ShapeError);
  EXPECT_NO_THROW(sampleLattice(SphereDistance(1), 1e-3));
  // thinner than the spacing: one layer
  const SampleLattice thin = sampleLattice(BoxDistance({1, 1, 0.01}), 0.1);
  EXPECT_EQ(thin.count[2], 1);
  EXPECT_EQ(countSamples(BoxDistance({1, 1, 0.01}), thin, {0, thin.rows()}), 100);
}

TEST(Sampling, JitterIsSmallAndIndependent) {
  const Vec3d x{1, 2, 3}, a = jittered(x, 0.2, 0.1, 1, 5);
  EXPECT_EQ(a, jittered(x, 0.2, 0.1, 1, 5));
  EXPECT_FALSE(a == jittered(x, 0.2, 0.1, 1, 6));
  EXPECT_FALSE(a == jittered(x, 0.2, 0.1, 2, 5));
  for (std::uint64_t k = 0; k < 1000; k++)
    for (int c = 0; c < 3; c++) ASSERT_LE(std::abs(jittered(x, 0.2, 0.1, 1, k)[c] - x[c]), 0.02);
}

TEST(Sampling, PullsSamplesInside) {
  const SphereDistance ball(1);
  const MeshDistance bust(bustMesh(), "bust");
  for (std::uint64_t k = 0; k < 500; k++) {
    const Vec3d x = randomPoint({{-2, -2, -2}, {2, 2, 2}}, k);
    const Vec3d y = pullInside(ball, x, 0.05);
    ASSERT_LE(ball.distance(y), -0.05);
    if (length(x) <= 0.95) { ASSERT_EQ(y, x); }
    const Vec3d near = randomPoint(bust.bounds(), k);
    if (bust.distance(near) < 0.02) { ASSERT_LE(bust.distance(pullInside(bust, near, 0.004)), 0); }
  }
  const BoxDistance sheet({1, 1, 0.02});  // too thin for the margin
  const Vec3d y = pullInside(sheet, {0, 0, 0.3}, 0.05);
  EXPECT_LT(sheet.distance(y), 0.011);
}

}  // namespace
}  // namespace thaw
