// SPDX-License-Identifier: Apache-2.0
// Closed meshes of components that cross periodic sides: in one piece, or cut at the sides and capped if they
// go all the way round.
#include <gtest/gtest.h>

#include <numbers>

#include "io/surface_mesh/surface_mesh.hpp"
#include "tests/support/closed_mesh.hpp"
#include "tests/support/surface/good_angles.hpp"
#include "tests/support/surface/surfel_samples.hpp"

using namespace thaw;

namespace {

constexpr double spacing = 0.03;

PeriodicSides sidesOf(bool x, bool y, bool z) { return {{x, y, z}, {-0.1, 0, 0.2}, {1, 1.3, 0.9}}; }

struct Surfaces {
  SurfaceFrame frame;
  /// Adds surfels, wrapped into the domain as in a run.
  void put(const SurfelSamples& s, const PeriodicSides& sides, bool inward = false) {
    for (std::size_t i = 0; i < s.size(); i++) {
      Vec3d x{s.positions[i].x, s.positions[i].y, s.positions[i].z};
      for (int a = 0; a < 3; a++)
        if (sides.is[static_cast<std::size_t>(a)])
          x[a] -= sides.period[a] * std::floor((x[a] - sides.min[a]) / sides.period[a]);
      frame.positions.push_back(x);
      frame.normals.push_back(inward ? -s.normals[i] : s.normals[i]);
      frame.radii.push_back(s.radii[i]);
      frame.components.push_back(5);
      frame.colours.push_back({10, 20, 30});
    }
  }
  /// Adds surfels on the faces of a box where `keep` is true.
  template<class Keep> void addBox(const TriangleMesh& box, const PeriodicSides& sides, Keep keep) {
    SurfelSamples all, kept;
    sampleMesh(all, box, spacing, false, 5);
    for (std::size_t i = 0; i < all.size(); i++) {
      const Vec3d x{all.positions[i].x, all.positions[i].y, all.positions[i].z};
      if (keep(x)) kept.add(x, {all.normals[i].x, all.normals[i].y, all.normals[i].z}, spacing, 5);
    }
    put(kept, sides);
  }
  void addBall(const Vec3d& centre, double radius, const PeriodicSides& sides, bool inward = false) {
    SurfelSamples s;
    sampleBall(s, centre, radius, spacing, 5);
    put(s, sides, inward);
  }
  ComponentMesh mesh(const PeriodicSides& sides) const {
    return meshOfComponent(frame, rowsByComponent(frame).at(0), frame.colours, sides);
  }
};

double ballVolume(double r) { return 4 * std::numbers::pi / 3 * r * r * r; }

void expectShells(const TriangleMesh& mesh, std::size_t shells) {
  EXPECT_EQ(shellVolumes(mesh).size(), shells);
  expectClosed(mesh);
}

std::array<double, 2> rangeOf(const TriangleMesh& mesh, int axis) {
  std::array<double, 2> range{1e9, -1e9};
  for (const Vec3d& v : mesh.vertices) range = {std::min(range[0], v[axis]), std::max(range[1], v[axis])};
  return range;
}

}  // namespace

TEST(PeriodicMesh, BallAcrossACornerIsInOnePiece) {
  const PeriodicSides sides = sidesOf(true, true, true);
  for (const Vec3d centre : {Vec3d{-0.13, 1.31, 0.22}, Vec3d{0.88, 0.02, 1.07}, Vec3d{0.4, 0.6, 0.6}}) {
    Surfaces s;
    s.addBall(centre, 0.3, sides);
    const ComponentMesh m = s.mesh(sides);
    expectShells(m.mesh, 1);
    EXPECT_EQ(m.cut, (std::array<bool, 3>{}));
    EXPECT_NEAR(volumeOf(m.mesh), ballVolume(0.3), 0.01 * ballVolume(0.3));
    Vec3d middle;
    for (int a = 0; a < 3; a++) {
      const auto [low, high] = rangeOf(m.mesh, a);
      EXPECT_NEAR(high - low, 0.6, 0.01);
      middle[a] = 0.5 * (low + high);
      EXPECT_TRUE(middle[a] > sides.min[a] - 0.01 && middle[a] < sides.min[a] + sides.period[a] + 0.01) << a;
    }
    // the same ball elsewhere without periodic sides
    Surfaces alone;
    alone.addBall(middle, 0.3, {});
    EXPECT_NEAR(volumeOf(alone.mesh({}).mesh), volumeOf(m.mesh), 1e-3 * ballVolume(0.3));
  }
}

TEST(PeriodicMesh, SpanningComponentsAreCutAtTheSidesAndCapped) {
  const PeriodicSides sides = sidesOf(true, false, false);
  // longer than the domain, so that its ends are left out
  const TriangleMesh rod = boxMesh({-1.5, 0.4, 0.5}, {1.9, 0.7, 0.8});
  Surfaces s;
  s.addBox(rod, sides, [](const Vec3d& x) { return x.x >= -0.1 && x.x < 0.9; });
  const ComponentMesh m = s.mesh(sides);
  expectShells(m.mesh, 1);
  expectGoodAngles(m.mesh);
  EXPECT_EQ(m.cut, (std::array<bool, 3>{true, false, false}));
  EXPECT_NEAR(volumeOf(m.mesh), 0.09, 0.01 * 0.09);
  EXPECT_NEAR(rangeOf(m.mesh, 0)[0], -0.1, 1e-12);
  EXPECT_NEAR(rangeOf(m.mesh, 0)[1], 0.9, 1e-12);
  double cap = 0;  // area on the plane that faces along x
  for (const auto& t : m.mesh.triangles) {
    const Vec3d area = 0.5 * cross(m.mesh.vertices[t[1]] - m.mesh.vertices[t[0]],
                                   m.mesh.vertices[t[2]] - m.mesh.vertices[t[0]]);
    if (std::abs(m.mesh.vertices[t[0]].x - 0.9) < 1e-9 && std::abs(m.mesh.vertices[t[1]].x - 0.9) < 1e-9 &&
        std::abs(m.mesh.vertices[t[2]].x - 0.9) < 1e-9) {
      EXPECT_NEAR(area.x, length(area), 1e-15);
      cap += area.x;
    }
  }
  EXPECT_NEAR(cap, 0.09, 0.01 * 0.09);
}

TEST(PeriodicMesh, PoolIsOneBlockWithItsBubblesAndDrops) {
  const PeriodicSides sides = sidesOf(true, true, false);
  const TriangleMesh pool = boxMesh({-2, -2, 0.3}, {3, 3, 0.8});
  Surfaces s;
  s.addBox(pool, sides, [](const Vec3d& x) { return x.x >= -0.1 && x.x < 0.9 && x.y >= 0 && x.y < 1.3; });
  s.addBall({-0.12, 1.25, 0.55}, 0.15, sides, true);
  const ComponentMesh m = s.mesh(sides);
  expectShells(m.mesh, 1);
  expectGoodAngles(m.mesh);
  EXPECT_EQ(m.cut, (std::array<bool, 3>{true, true, false}));
  const double volume = 1.3 * 0.5 - ballVolume(0.15);
  EXPECT_NEAR(volumeOf(m.mesh), volume, 0.005 * volume);
}

TEST(PeriodicMesh, CavityIsPlacedInItsBody) {
  const PeriodicSides sides = sidesOf(false, true, false);
  Surfaces s;
  s.addBall({0.4, 1.2, 0.6}, 0.35, sides);
  s.addBall({0.4, 1.32, 0.6}, 0.15, sides, true);
  const ComponentMesh m = s.mesh(sides);
  expectShells(m.mesh, 2);
  EXPECT_EQ(m.cut, (std::array<bool, 3>{}));
  EXPECT_NEAR(rangeOf(m.mesh, 1)[1] - rangeOf(m.mesh, 1)[0], 0.7, 0.01);
  EXPECT_NEAR(volumeOf(m.mesh), ballVolume(0.35) - ballVolume(0.15), 0.01 * ballVolume(0.35));
}

TEST(PeriodicMesh, BodyFillsTheDomainAroundASingleCavity) {
  const PeriodicSides sides = sidesOf(true, true, true);
  Surfaces s;
  s.addBall({0.9, 0, 0.6}, 0.3, sides, true);
  const ComponentMesh m = s.mesh(sides);
  expectShells(m.mesh, 1);
  expectGoodAngles(m.mesh);
  EXPECT_EQ(m.cut, (std::array<bool, 3>{true, true, true}));
  const double volume = 1.3 * 0.9 - ballVolume(0.3);
  EXPECT_NEAR(volumeOf(m.mesh), volume, 0.005 * volume);
}

TEST(PeriodicMesh, BodyNearItsOwnImageIsNotSpanning) {
  const PeriodicSides sides = sidesOf(true, false, false);
  Surfaces s;
  // a gap of 2.3 spacings; below two it would be cut, equally correct
  s.addBox(boxMesh({0.2, 0.4, 0.5}, {1.13, 0.7, 0.8}), sides, [](const Vec3d&) { return true; });
  const ComponentMesh m = s.mesh(sides);
  expectShells(m.mesh, 1);
  expectGoodAngles(m.mesh);
  EXPECT_EQ(m.cut, (std::array<bool, 3>{}));
  EXPECT_NEAR(volumeOf(m.mesh), 0.93 * 0.09, 0.01 * 0.09);
}
