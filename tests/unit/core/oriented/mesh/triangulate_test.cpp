// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/mesh/triangulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/geometry/trees/point_tree.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/interpolation/interpolant.hpp"

namespace thaw {
namespace {

std::vector<Vec3d> onSphere(int n) {
  std::vector<Vec3d> points;
  for (int k = 0; k < n; k++) {
    const double z = 1 - (2.0 * k + 1) / n, r = std::sqrt(1 - z * z), a = 2.39996322972865332 * k;
    points.push_back({r * std::cos(a), r * std::sin(a), z});
  }
  return points;
}

TEST(Triangulate, SphereIsClosed) {
  const std::vector<Vec3d> points = onSphere(500);
  const std::vector<double> spacing(points.size(), std::sqrt(4 * std::numbers::pi / 500 / 0.866));
  const auto triangles = triangulate({points, points, spacing, {}, {}});
  const auto edges = edgesOf(triangles);
  // Euler: V - E + F = 2, and every edge has two triangles
  EXPECT_EQ(points.size() + triangles.size(), edges.size() + 2);
  EXPECT_EQ(3 * triangles.size(), 2 * edges.size());
  for (const auto& t : triangles)
    EXPECT_GT(dot(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]), points[t[0]]), 0);
}

TEST(Triangulate, CutsAndGroupsSeparateParts) {
  std::vector<Vec3d> points, normals;
  std::vector<std::uint64_t> sides;
  for (int j = 0; j < 9; j++)
    for (int i = 0; i < 10; i++) {
      points.push_back({i + 0.5 * (j % 2), 0.866 * j, 0});
      normals.push_back({0, 0, 1});
      sides.push_back(i < 5 ? 1 : 2);
    }
  const std::vector<double> spacing(points.size(), 1.0);
  const auto whole = triangulate({points, normals, spacing, {}, {}}),
             cut = triangulate({points, normals, spacing, {}, sides});
  // plus 7 at the teeth of the left and right borders, where the outside of the sphere is empty
  EXPECT_EQ(whole.size(), 8u * 9 * 2 + 7);
  EXPECT_EQ(cut.size(), 8u * 8 * 2 + 14);
  for (const auto& t : cut) EXPECT_TRUE(sides[t[0]] == sides[t[1]] && sides[t[1]] == sides[t[2]]);
}

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;
/// Number of triangles that run along each directed edge.
Edges directed(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Edges sides;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; k++) sides[{t[k], t[(k + 1) % 3]}]++;
  return sides;
}
std::size_t borderOf(const Edges& sides) {
  std::size_t border = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1) << "two triangles run along an edge the same way";
    border += !sides.contains({side.second, side.first});
  }
  return border;
}

// A fold as sharp as its spacing, with positions displaced by a quarter of it. Testing each triangle alone
// gives edges with three triangles, and holes.
constexpr int foldSize = 24;
OrientedPoints foldOf(std::uint64_t seed, double steep, std::vector<Vec3d>& points,
                      std::vector<Vec3d>& normals, std::vector<double>& spacing) {
  constexpr int n = foldSize;
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++) {
      const std::uint64_t point = points.size();
      const auto off = [&](std::uint64_t a) {
        return 0.5 * (randomUniform(9 + 3 * seed + a, Purpose::Test, point) - 0.5);
      };
      const double x = i + 0.5 * (j % 2) - 0.5 * n + off(0), slope = x < 0 ? steep : -steep;
      points.push_back({x, 0.866 * j + off(1), -std::abs(steep * x) + 0.4 * off(2)});
      normals.push_back(normalized(Vec3d{std::abs(x) < 0.5 ? 0 : -slope, 0, 1}));
    }
  spacing.assign(points.size(), 1.1);
  return {points, normals, spacing, {}, {}};
}

TEST(Triangulate, EdgesHaveAtMostTwoTrianglesAndHolesAreFilled) {
  std::vector<Vec3d> points, normals;
  std::vector<double> spacing;
  const auto triangles = triangulate(foldOf(0, 1.4, points, normals, spacing));
  const std::size_t border = borderOf(directed(triangles));
  EXPECT_GT(triangles.size(), 1000u);
  EXPECT_LT(border, 4u * foldSize + 20);  // only the rim
}

// Where other triangles join a hole's corners, no ear is free: these are removed, and the larger hole is
// closed.
TEST(Triangulate, HolesInSharpFoldsAreClosed) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 60; seed++) {
    std::vector<Vec3d> points, normals;
    std::vector<double> spacing;
    const Edges sides = directed(triangulate(foldOf(seed, 1.7, points, normals, spacing)));
    borderOf(sides);
    const auto atRim = [&](std::uint32_t i) {
      return points[i].y < 2 || points[i].y > 0.866 * foldSize - 3 ||
             std::abs(points[i].x) > 0.5 * foldSize - 2;
    };
    for (const auto& [side, count] : sides)
      inside += !sides.contains({side.second, side.first}) && !atRim(side.first) && !atRim(side.second);
  }
  EXPECT_EQ(inside, 0);
}

TEST(Triangulate, SquaresOfFourOnACircleAreTwoTriangles) {
  std::vector<Vec3d> points, normals(100, Vec3d{0, 0, 1});
  for (int k = 0; k < 100; k++)
    points.push_back({static_cast<double>(k % 10), static_cast<double>(k / 10), 0});
  const auto triangles = triangulate({points, normals, std::vector<double>(100, 1.0), {}, {}});
  EXPECT_EQ(triangles.size(), 2u * 81);
  EXPECT_EQ(borderOf(directed(triangles)), 36u);
}

TEST(Triangulate, ACurveIsJoinedToALine) {
  std::vector<Vec3d> points, normals;
  for (int k = 0; k < 30; k++) {
    points.push_back({std::cos(0.15 * k), 0, std::sin(0.15 * k)});
    normals.push_back(points.back());
  }
  const std::vector<double> spacing(30, 0.15);
  const auto lines = joinLines({points, normals, spacing, {}, {}}, std::vector<std::uint8_t>(30, 1));
  ASSERT_EQ(lines.size(), 29u);
  for (std::uint32_t k = 0; k < 29; k++) EXPECT_TRUE(lines[k][0] == k && lines[k][1] == k + 1);
}

TEST(PointTree, NearestEqualAPlainSearch) {
  std::vector<Vec3d> points;
  for (std::uint64_t k = 0; k < 600; k++)
    points.push_back({randomUniform(1, Purpose::Test, k), randomUniform(2, Purpose::Test, k),
                      k % 3 == 0 ? 0.5 : randomUniform(3, Purpose::Test, k)});
  const PointTree tree(points);
  for (std::uint64_t q = 0; q < 50; q++) {
    const Vec3d x{randomUniform(4, Purpose::Test, q), randomUniform(5, Purpose::Test, q),
                  randomUniform(6, Purpose::Test, q)};
    std::vector<std::uint32_t> plain(points.size());
    for (std::uint32_t k = 0; k < plain.size(); k++) plain[k] = k;
    std::stable_sort(plain.begin(), plain.end(), [&](auto a, auto b) {
      return dot(points[a] - x, points[a] - x) < dot(points[b] - x, points[b] - x);
    });
    plain.resize(9);
    EXPECT_EQ(tree.nearest(x, 9), plain);
    std::vector<std::uint32_t> near;
    for (std::uint32_t k = 0; k < points.size(); k++)
      if (length(points[k] - x) < 0.2) near.push_back(k);
    EXPECT_EQ(tree.within(x, 0.2), near);
  }
}

TEST(GivenSurface, NormalsOfASphereAllPointOutward) {  // stability row 17
  const std::vector<Vec3d> points = onSphere(400), normals = normalsOf(points);
  for (std::size_t k = 0; k < points.size(); k++) EXPECT_GT(dot(points[k], normals[k]), 0.98);
}

TEST(GivenSurface, ThinPlateGoesThroughItsPoints) {
  const std::vector<Vec3d> control{{0, 0, 0}, {1, 0, 0.2}, {0, 1, -0.1}, {1, 1, 0.3}, {0.5, 0.4, 0.5}};
  const ThinPlate plate = thinPlate(control);
  for (std::size_t k = 0; k < control.size(); k++)
    EXPECT_LT(length(plate.at(plate.x[k], plate.y[k]) - control[k]), 1e-9);
  EXPECT_THROW(thinPlate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), std::invalid_argument);
}

TEST(GivenSurface, ProjectionFindsTheSphere) {
  PointInterpolant given;
  given.points = given.normals = onSphere(150);
  buildInterpolant(given);
  for (int k = 0; k < 40; k++) {
    Vec3d x = 1.05 * normalized(Vec3d{std::sin(k * 1.0), std::cos(k * 2.0), std::sin(k * 0.7 + 1)}),
          n = normalized(x);
    ASSERT_TRUE(projectOnInterpolant(given, x, n));
    EXPECT_NEAR(length(x), 1, 0.01);
    EXPECT_GT(dot(n, normalized(x)), 0.99);
  }
  Vec3d far{5, 0, 0}, n{1, 0, 0};
  EXPECT_FALSE(projectOnInterpolant(given, far, n));
}

}  // namespace
}  // namespace thaw
