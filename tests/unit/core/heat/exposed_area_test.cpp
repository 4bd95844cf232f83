// SPDX-License-Identifier: Apache-2.0
#include "core/heat/exposed_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/heat/conduction_correction.hpp"
#include "core/kernels/lattice.hpp"

namespace thaw::test {
namespace {

using std::numbers::pi;
using Filled = std::function<bool(int, int, int)>;

/// Area of the particle at the origin of a lattice.
double latticeArea(const Numerics& n, const Filled& filled) {
  const ExposedAreaLaw law = exposedAreaLaw(n);
  const double reach = law.reach * n.support;
  double sum = 0;
  Vec3d asymmetry{};
  for (int x = -2; x <= 2; x++)
    for (int y = -2; y <= 2; y++)
      for (int z = -2; z <= 2; z++) {
        const Vec3d d{1.0 * x, 1.0 * y, 1.0 * z};
        const double r = length(d), q = r / reach;
        if (r == 0 || q >= 1 || !filled(x, y, z)) continue;
        sum += q * (1 - q * q);
        asymmetry += d * (q * (1 - q * q) / r);
      }
  return areaOf(law, sum, length(asymmetry));
}

}  // namespace

TEST(ExposedArea, EqualsTheOpenFacesOfALattice) {
  for (const double support : {1.5, 2.0, 3.0}) {
    Numerics n;
    n.support = support;
    const auto area = [&](const Filled& filled) { return latticeArea(n, filled); };
    const double rounded = support < 2 ? 1e-9 : 1e-3;  // the tables have three decimal places
    EXPECT_NEAR(area([](int, int, int) { return true; }), 0, 1e-9);
    EXPECT_NEAR(area([](int, int, int z) { return z <= 0; }), 1, 1e-9);
    EXPECT_NEAR(area([](int, int y, int z) { return z <= 0 && y <= 0; }), 2, rounded);
    EXPECT_NEAR(area([](int x, int y, int z) { return z <= 0 && y <= 0 && x <= 0; }), 3, 0.1);
    EXPECT_NEAR(area([](int, int, int z) { return z == 0; }), 2, 1e-9);
    EXPECT_NEAR(area([](int, int y, int z) { return z == 0 && y <= 0; }), 3, 0.2);
    EXPECT_NEAR(area([](int, int y, int z) { return z == 0 && y == 0; }), 4, 0.2);
    EXPECT_NEAR(area([](int, int, int) { return false; }), 6, 0.4);
  }
}

namespace {

/// Total area of the particles of a lattice within `extent` for which inside(position) and counted(position)
/// are true.
double totalArea(const Vec3d& offset, int extent, const std::function<bool(const Vec3d&)>& inside,
                 const std::function<bool(const Vec3d&)>& counted) {
  const Numerics n;
  double sum = 0;
  for (int x = -extent; x <= extent; x++)
    for (int y = -extent; y <= extent; y++)
      for (int z = -extent; z <= extent; z++) {
        const Vec3d p = offset + Vec3d{1.0 * x, 1.0 * y, 1.0 * z};
        if (inside(p) && counted(p))
          sum += latticeArea(n, [&](int a, int b, int c) {
            return inside(p + Vec3d{1.0 * a, 1.0 * b, 1.0 * c});
          });
      }
  return sum;
}

const Vec3d offsets[] = {{0, 0, 0}, {0.5, 0.5, 0.5}, {0.21, -0.34, 0.47}, {0.5, 0.13, -0.28}};

}  // namespace

TEST(ExposedArea, OfBallsDependsLittleOnTheLattice) {
  for (const double r : {4.0, 6.0, 8.0, 12.0})
    for (const Vec3d& offset : offsets) {
      const double area = totalArea(
          offset, static_cast<int>(r) + 1, [&](const Vec3d& p) { return dot(p, p) < r * r; },
          [](const Vec3d&) { return true; });
      EXPECT_NEAR(area / (4 * pi * r * r), 1, r < 6 ? 0.1 : r < 8 ? 0.06 : 0.03) << r << ' ' << offset.x;
    }
}

// The plane bounds a half-space. Particles near it are counted within a cylinder around its normal.
TEST(ExposedArea, OfPlanesDependsLittleOnTheLattice) {
  constexpr double radius = 9;
  for (const Vec3d& direction :
       {Vec3d{1, 0, 0}, Vec3d{1, 1, 0}, Vec3d{1, 1, 1}, Vec3d{1, 0, 2}, Vec3d{1, 0, 4}, Vec3d{1, 1, 2},
        Vec3d{1, 2, 2}, Vec3d{0.31, 0.52, 0.79}, Vec3d{0.11, 0.27, 0.95}}) {
    const Vec3d normal = direction * (1 / length(direction));
    double sum = 0;
    for (const Vec3d& offset : offsets)
      sum += totalArea(
          offset, 12, [&](const Vec3d& p) { return dot(p, normal) < 0; },
          [&](const Vec3d& p) {
            const double z = dot(p, normal);
            return z > -4 && dot(p, p) - z * z < radius * radius;
          });
    EXPECT_NEAR(sum / (4 * pi * radius * radius), 1, 0.06)
        << direction.x << ' ' << direction.y << ' ' << direction.z;
  }
}

TEST(ExposedArea, OfAFaceIsCoveredByAWall) {
  const ExposedAreaLaw law = exposedAreaLaw({});
  EXPECT_NEAR(coveredArea(law, 0.5), 1, 1e-12);
  EXPECT_EQ(coveredArea(law, 1.5), 0);
  EXPECT_GT(coveredArea(law, 0.8), 0.3);
  EXPECT_LT(coveredArea(law, 0.8), 0.9);
}

TEST(ExposedArea, IgnoresDisorder) {
  EXPECT_EQ(clearArea(-1), 0);
  EXPECT_EQ(clearArea(0.17), 0);
  EXPECT_LT(clearArea(0.3), 0.3);
  EXPECT_EQ(clearArea(1), 1);
}

namespace {

ConductionSums conductionSums(const Numerics& n, const Filled& filled) {
  Sym3d m;
  double weight = 0;
  for (int x = -2; x <= 2; x++)
    for (int y = -2; y <= 2; y++)
      for (int z = -2; z <= 2; z++) {
        const Vec3d d = Vec3d{1.0 * x, 1.0 * y, 1.0 * z} * (1 / n.support);
        if (dot(d, d) == 0 || dot(d, d) >= 1 || !filled(x, y, z)) continue;
        const double u = 1 - length(d), w = u * u * u;  // Wendland C2
        weight += w;
        m = m + w * Sym3d{d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.x * d.z};
      }
  const double scale = 420 / (pi * n.support * n.support * n.support);
  return {static_cast<float>(scale * weight), single(scale * m)};
}

}  // namespace

TEST(ConductionCorrection, RestoresTheMomentAlongASurface) {
  const Numerics n;
  const LatticeConduction lattice = latticeConduction(n);
  EXPECT_NEAR(lattice.moment, 2 * latticeLaplacian(n), 1e-12);
  const auto factor = [&](const Filled& filled) {
    return conductionFactor(lattice, conductionSums(n, filled));
  };
  EXPECT_EQ(factor([](int, int, int) { return true; }), 1);
  const Filled face = [](int, int, int z) { return z <= 0; },
               edge = [](int, int y, int z) { return z <= 0 && y <= 0; };
  for (const Filled& filled : {face, edge})
    EXPECT_NEAR(factor(filled) * static_cast<double>(conductionSums(n, filled).moment.xx), lattice.moment,
                1e-6 * lattice.moment);
  EXPECT_GT(factor(face), 1.1);
  EXPECT_LT(factor(face), 1.2);
  EXPECT_LE(factor([](int, int, int) { return false; }), 2);
}

// Two particles that nearly coincide have a large weight. The factor must not make their step unstable.
TEST(ConductionCorrection, IsLimitedByTheStableStep) {
  const LatticeConduction lattice = latticeConduction({});
  const float heavy = static_cast<float>(lattice.weight);
  EXPECT_NEAR(conductionFactor(lattice, {heavy, {}}), 1, 1e-6);
  EXPECT_NEAR(conductionFactor(lattice, {heavy / 1.5f, {}}), 1.5, 1e-6);
}

}  // namespace thaw::test
