// SPDX-License-Identifier: Apache-2.0
// The surface through given points with normals.
#include "core/oriented/interpolation/interpolant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {
namespace {

/// Points on an ellipsoid with these half axes, evenly along a spiral.
PointInterpolant onEllipsoid(int count, const Vec3d& axes) {
  PointInterpolant g;
  for (int k = 0; k < count; k++) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z), a = 2.399963229728653 * k;
    const Vec3d u{r * std::cos(a), r * std::sin(a), z};
    g.points.push_back({axes.x * u.x, axes.y * u.y, axes.z * u.z});
    g.normals.push_back(normalized(Vec3d{u.x / axes.x, u.y / axes.y, u.z / axes.z}));
  }
  buildInterpolant(g);
  return g;
}
PointInterpolant onSphere(int count) { return onEllipsoid(count, {0.3, 0.3, 0.3}); }

double worstOff(const PointInterpolant& g, const Vec3d& axes) {
  double worst = 0;
  for (int k = 0; k < 500; k++) {
    const double z = std::sin(0.7 * k), r = std::sqrt(1 - z * z);
    const Vec3d u{r * std::cos(1.9 * k), r * std::sin(1.9 * k), z};
    Vec3d normal = normalized(Vec3d{u.x / axes.x, u.y / axes.y, u.z / axes.z}),
          place = Vec3d{axes.x * u.x, axes.y * u.y, axes.z * u.z} + 0.02 * std::sin(5.0 * k) * normal;
    EXPECT_TRUE(projectOnInterpolant(g, place, normal));
    const Vec3d q{place.x / axes.x, place.y / axes.y, place.z / axes.z},
        slope{q.x / axes.x, q.y / axes.y, q.z / axes.z};
    worst = std::max(worst, std::abs(dot(q, q) - 1) / (2 * length(slope)));  // distance, to first order
    EXPECT_GT(dot(normal, normalized(slope)), 0.97);
  }
  return worst;
}

TEST(GivenSurface, SpherePointsGiveASphere) { EXPECT_LT(worstOff(onSphere(60), {0.3, 0.3, 0.3}), 1e-12); }

TEST(GivenSurface, ConvergesToAnEllipsoid) {
  const Vec3d axes{0.3, 0.25, 0.2};
  const double few = worstOff(onEllipsoid(80, axes), axes), many = worstOff(onEllipsoid(320, axes), axes);
  EXPECT_LT(few, 2e-3);
  EXPECT_LT(many, 0.25 * few);  // at half the distance: second order at least
}

TEST(GivenSurface, GoesThroughItsPointsAndEndsBeyondThem) {
  const PointInterpolant g = onSphere(60);
  for (std::size_t k = 0; k < g.points.size(); k++) {
    Vec3d place = g.points[k] + 0.01 * g.normals[k], normal = g.normals[k];
    ASSERT_TRUE(projectOnInterpolant(g, place, normal));
    EXPECT_LT(length(place - g.points[k]), 2e-3);
  }
  Vec3d far{1.5, 0, 0}, normal{1, 0, 0};
  EXPECT_FALSE(projectOnInterpolant(g, far, normal));
}

// Two thirds of the thinned points are even, the others are where the surface would err most. No region is
// left out, and no two points coincide.
TEST(GivenSurface, ThinningKeepsTheRequestedNumberAndCoversTheSurface) {
  OrientedBody b;
  b.shape.kind = ShapeKind::Mesh;
  b.shape.mesh = "builtin:head";
  const auto places = sampleMesh(b.shape, 0.04, 3, {}).places;
  const std::size_t all = places.size();
  b.thin = 0.05;
  const SampledPoints few = samplePoints(b, 0.04, 3, {});
  EXPECT_NEAR(static_cast<double>(few.places.size()), 0.05 * static_cast<double>(all),
              0.01 * static_cast<double>(all));
  double least = 1;
  for (std::size_t i = 0; i < few.places.size(); i++)
    for (std::size_t j = 0; j < i; j++)
      if (dot(few.normals[i], few.normals[j]) > 0)
        least = std::min(least, length(few.places[i] - few.places[j]));
  EXPECT_GT(least, 0.04);
  double farthest = 0;
  for (const Vec3d& x : places) {
    double nearest = 1;
    for (const Vec3d& kept : few.places) nearest = std::min(nearest, length(x - kept));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 5.5 * 0.04);  // distance of even points, two thirds of 5 %: 1 / sqrt(0.033)
}

}  // namespace
}  // namespace thaw
