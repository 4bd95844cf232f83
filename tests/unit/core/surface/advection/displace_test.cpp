// SPDX-License-Identifier: Apache-2.0
#include "core/surface/advection/displace.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::RelaxRig;

void freeze(RelaxRig& rig) {
  SurfaceParticles& p = rig.w.surface.particles;
  std::fill_n(p.liquid.data(), p.owned, 0.0f);
}

void carry(RelaxRig& rig) {
  rig.place();
  findDisplacementGradients(rig.w.grid, rig.w.surface, rig.ranks->halos(), rig.tools);
  displaceSurfels(rig.w.scene, rig.w.surface, rig.ranks->halos(), rig.tools);
}

void affineMotionIsExact(bool frozen) {
  RelaxRig rig;
  rig.addLattice(5, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return length(x) < 5; });
  rig.addBallSurfels(5);
  if (frozen) freeze(rig);
  const Mat3d g{{{0.1, -0.2, 0.05}, {0.15, 0.02, 0.1}, {-0.1, 0.07, -0.05}}};
  const Vec3d t{0.3, -0.4, 0.1};
  SurfaceParticles& p = rig.w.surface.particles;
  for (std::size_t i = 0; i < p.owned; i++) p.displacement[i] = g * p.position[i] + t;
  Surfels& s = rig.w.surface.surfels;
  std::vector<Vec3d> wanted(s.owned), normal(s.owned), tangent(s.owned);
  const Mat3d f = identity3<double>() + g;
  for (std::size_t i = 0; i < s.owned; i++) {
    const std::size_t k = s.id[i] - 1000;
    wanted[k] = s.position[i] + g * s.position[i] + t;
    normal[k] = normalized(transpose(inverse(f)) * s.normal[i]);
    tangent[k] = normalized(f * s.tangent[i]);
  }
  carry(rig);
  ASSERT_EQ(s.owned, wanted.size());
  for (std::size_t i = 0; i < s.owned; i++) {
    const std::size_t k = s.id[i] - 1000;
    EXPECT_LT(length(s.position[i] - wanted[k]), 1e-12);
    EXPECT_LT(length(s.normal[i] - normal[k]), 1e-12);
    EXPECT_LT(length(s.tangent[i] - tangent[k]), 1e-12);
    EXPECT_EQ(s.carried[i], s.position[i]);
  }
}

TEST(Displace, AffineMotionIsExact) {
  affineMotionIsExact(false);
  affineMotionIsExact(true);
}

// A body bends about a line by 60 degrees in 12 updates, within two spacings. Discs must stay in the plane of
// their neighbours. The mean of the particles' gradients is smoother than the displacement of positions and
// would leave them up to 12 degrees out of plane.
TEST(Displace, NormalsTurnWithPositions) {
  RelaxRig rig;
  rig.addLattice(6, {0.3, 0.1, 0.2}, [](const Vec3d& x) {
    return std::abs(x.x) < 6 && std::abs(x.y) < 3 && x.z < 0 && x.z > -3;
  });
  freeze(rig);
  const double near = 1e-4;
  std::vector<Vec3d> at;
  for (int k = -8; k <= 8; k++)
    for (const Vec3d& off : {Vec3d{}, Vec3d{near, 0, 0}, Vec3d{0, near, 0}})
      rig.addSurfel(Vec3d{0.5 * k, 0.1, 0} + off, {0, 0, 1});
  Surfels& s = rig.w.surface.surfels;
  SurfaceParticles& p = rig.w.surface.particles;
  using std::numbers::pi;
  std::vector<double> from(p.owned);
  for (std::size_t i = 0; i < p.owned; i++) from[p.id[i]] = p.position[i].x;
  for (int update = 0; update < 12; update++) {
    const double a = pi / 3 / 12;
    for (std::size_t i = 0; i < p.owned; i++) {
      // x0 > 1 turns by a, x0 < -1 stays
      const double x0 = from[p.id[i]], turn = a * std::clamp(0.5 + 0.5 * x0, 0.0, 1.0);
      const Vec3d x = p.position[i];
      p.displacement[i] = Vec3d{std::cos(turn) * x.x + std::sin(turn) * x.z, x.y,
                                -std::sin(turn) * x.x + std::cos(turn) * x.z} -
                          x;
    }
    carry(rig);
    p.resize(p.owned, 0);
    for (std::size_t i = 0; i < p.owned; i++) p.position[i] += p.displacement[i];
  }
  std::vector<std::size_t> row(s.owned);
  for (std::size_t i = 0; i < s.owned; i++) row[s.id[i] - 1000] = i;
  double worst = 0;
  for (std::size_t k = 0; k < s.owned; k += 3) {
    const Vec3d x = s.position[row[k]],
                n = normalized(cross(s.position[row[k + 1]] - x, s.position[row[k + 2]] - x));
    worst = std::max(worst, std::acos(std::min(1.0, dot(n, s.normal[row[k]]))) * 180 / pi);
  }
  EXPECT_LT(worst, 0.1);
}

TEST(Displace, AFullTurnInManyUpdatesEndsWhereItBegan) {
  RelaxRig rig;
  rig.addLattice(4, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return length(x) < 4; });
  rig.addBallSurfels(4);
  freeze(rig);
  Surfels& s = rig.w.surface.surfels;
  SurfaceParticles& p = rig.w.surface.particles;
  std::vector<Vec3d> begin(s.owned), normal(s.owned);
  for (std::size_t i = 0; i < s.owned; i++)
    begin[s.id[i] - 1000] = s.position[i], normal[s.id[i] - 1000] = s.normal[i];
  const int updates = 100;
  const double a = 2 * std::numbers::pi / updates, c = std::cos(a), n = std::sin(a);
  for (int k = 0; k < updates; k++) {
    for (std::size_t i = 0; i < p.owned; i++) {
      const Vec3d x = p.position[i];
      p.displacement[i] = Vec3d{c * x.x - n * x.y, n * x.x + c * x.y, x.z} - x;
    }
    carry(rig);
    p.resize(p.owned, 0);
    for (std::size_t i = 0; i < p.owned; i++) p.position[i] += p.displacement[i];
  }
  for (std::size_t i = 0; i < s.owned; i++) {
    EXPECT_LT(length(s.position[i] - begin[s.id[i] - 1000]), 1e-9 * s.radius[i]);
    EXPECT_LT(length(s.normal[i] - normal[s.id[i] - 1000]), 1e-9);
  }
}

TEST(Displace, SheetsRowsAndSingleParticlesTurnAsRigidBodies) {
  for (int kind = 0; kind < 3; kind++) {  // a sheet, a row, one particle
    RelaxRig rig;
    const int nx = kind == 2 ? 0 : 3, ny = kind == 0 ? 3 : 0;
    for (int y = -ny; y <= ny; y++)
      for (int x = -nx; x <= nx; x++) rig.addParticle({double(x), double(y), 0});
    const Vec3d at = {0.2, 0.1, 0.5};
    rig.addSurfel(at, {0, 0, 1});
    const double c = std::cos(0.3), n = std::sin(0.3);
    const auto turn = [&](const Vec3d& x) {
      return Vec3d{c * x.x + n * x.z, x.y, -n * x.x + c * x.z} + Vec3d{0, 0, 0.4};
    };
    SurfaceParticles& p = rig.w.surface.particles;
    for (std::size_t i = 0; i < p.owned; i++) p.displacement[i] = turn(p.position[i]) - p.position[i];
    carry(rig);
    ASSERT_EQ(rig.w.surface.surfels.owned, 1u);
    const Vec3d wanted = kind == 2 ? at + Vec3d{0, 0, 0.4} : turn(at);  // one particle defines no rotation
    EXPECT_LT(length(rig.w.surface.surfels.position[0] - wanted), 1e-12) << kind;
  }
}

// A plate of one layer turns by a right angle while its ripples reverse. They do not affect its thickness,
// and its sides stay apart.
TEST(Displace, ARippledPlateKeepsItsThickness) {
  RelaxRig rig;
  std::vector<double> ripple;
  for (int y = -5; y <= 5; y++)
    for (int x = -5; x <= 5; x++) {
      ripple.push_back(((x + y) & 1 ? 0.15 : -0.15) + 0.05 * std::sin(1.7 * x + 2.3 * y));
      rig.addParticle({static_cast<double>(x), static_cast<double>(y), ripple.back()});
    }
  for (int side = -1; side <= 1; side += 2)
    for (int y = -6; y <= 6; y++)
      for (int x = -6; x <= 6; x++)
        rig.addSurfel({0.5 * x, 0.5 * y, 0.5 * side}, {0, 0, static_cast<double>(side)});
  freeze(rig);
  const int updates = 12;
  const auto placeAt = [&](const Vec3d& at, double swing, double share) {
    const double a = share * std::numbers::pi / 2, z = at.z + swing;
    return Vec3d{at.x, std::cos(a) * at.y - std::sin(a) * z, std::sin(a) * at.y + std::cos(a) * z};
  };
  SurfaceParticles& p = rig.w.surface.particles;
  Surfels& s = rig.w.surface.surfels;
  for (int k = 0; k < updates; k++) {
    const double from = static_cast<double>(k) / updates, to = static_cast<double>(k + 1) / updates;
    for (std::size_t i = 0; i < p.owned; i++) {
      const std::size_t n = p.id[i];
      const Vec3d flat{static_cast<double>(n % 11) - 5, static_cast<double>(n / 11) - 5, 0};
      p.position[i] = placeAt(flat, std::cos(std::numbers::pi * from) * ripple[n], from);
      p.displacement[i] = placeAt(flat, std::cos(std::numbers::pi * to) * ripple[n], to) - p.position[i];
    }
    carry(rig);
  }
  for (std::size_t i = 0; i < s.owned; i++) {
    const double side = (s.id[i] - 1000) < s.owned / 2 ? -1 : 1;
    EXPECT_NEAR(-side * s.position[i].y, 0.5, 0.15);  // its plane is x, z at the end
  }
}

TEST(Displace, SurfelsWithoutParticlesFollowTheirNeighboursOrGo) {
  RelaxRig rig;
  for (int k = -1; k <= 1; k++) rig.addParticle({double(k), 0, 0}, {0.5, 0, 0});
  rig.addSurfel({0, 0, 3.9}, {0, 0, 1});
  rig.addSurfel({0, 0, 4.4}, {0, 0, 1});       // only the first surfel is near
  rig.addSurfel({10, 0, 0}, {0, 0, 1});        // no surfel is near
  rig.addSurfel({0, 0.3, 3.9}, {0, 0, 1}, 7);  // particles of another component
  carry(rig);
  const Surfels& s = rig.w.surface.surfels;
  ASSERT_EQ(s.owned, 2u);
  for (std::size_t i = 0; i < 2; i++) EXPECT_NEAR(s.position[i].x, 0.5, 1e-12);
  EXPECT_EQ(rig.w.surface.counters.lost, 2);
}

TEST(Displace, HandlesAnEmptySurface) {
  RelaxRig rig;
  carry(rig);
  rig.addSurfel({0, 0, 1}, {0, 0, 1});
  carry(rig);
  EXPECT_EQ(rig.w.surface.surfels.owned, 0u);
  EXPECT_EQ(rig.w.surface.counters.lost, 1);
}

TEST(Displace, SameBitsForEveryInstructionSet) {
  std::vector<Vec3d> first, firstNormals;
  for (const char* isa : {"base", "avx2", "avx512"}) {
    if (!surfaceKernels(isa)) continue;
    RelaxRig rig;
    rig.tools.relax.kernels = surfaceKernels(isa);
    rig.addLattice(4, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return length(x) < 4; });
    rig.addBallSurfels(4, 0.1);
    SurfaceParticles& p = rig.w.surface.particles;
    for (std::size_t i = 0; i < p.owned; i++)
      p.displacement[i] = 0.1 * Vec3d{std::sin(p.position[i].y), p.position[i].x * p.position[i].z,
                                      std::cos(p.position[i].x)};
    // the liquid part turns differently
    for (std::size_t i = 0; i < p.owned; i++) p.liquid[i] = p.position[i].z > 0 ? 1.0f : 0.0f;
    carry(rig);
    const Surfels& s = rig.w.surface.surfels;
    const std::vector<Vec3d> now(s.position.data(), s.position.data() + s.owned),
        normals(s.normal.data(), s.normal.data() + s.owned);
    if (first.empty()) first = now, firstNormals = normals;
    EXPECT_TRUE(first == now) << isa;
    EXPECT_TRUE(firstNormals == normals) << isa;
  }
}

// Melt falls off a solid, and the surface of the solid stays with it. The mean motion of all particles would
// draw it into the solid by a tenth of the melt's fall per update.
TEST(Displace, SurfaceOfASolidMovesWithTheSolid) {
  RelaxRig rig;
  rig.addLattice(5, {},
                 [](const Vec3d& x) { return std::abs(x.x) < 5 && std::abs(x.y) < 5 && std::abs(x.z) < 3; });
  SurfaceParticles& p = rig.w.surface.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool melt = p.position[i].z < 0;
    p.liquid[i] = melt ? 1 : 0;
    p.displacement[i] = {0, 0, melt ? -0.5 : 0};
  }
  rig.addSurfel({4.5, 0, 0.5}, {1, 0, 0});
  rig.addSurfel({4.5, 0, -1}, {1, 0, 0});
  Surfels& s = rig.w.surface.surfels;
  for (std::size_t i = 0; i < s.owned; i++) s.liquid[i] = s.position[i].z < 0 ? 1 : 0;
  carry(rig);
  for (std::size_t i = 0; i < s.owned; i++) {
    if (s.id[i] == 1000) EXPECT_NEAR(s.position[i].z, 0.5, 0.02);
    else EXPECT_LT(s.position[i].z, -1.2);
  }
}

TEST(Displace, NewParticlesAndOtherComponentsHaveNoEffect) {
  RelaxRig rig;
  rig.addLattice(3, {}, [](const Vec3d& x) { return length(x) < 3; });
  rig.addParticle({0.5, 0.5, 0.5}, {9, 9, 9}, noComponent);
  rig.addParticle({0.5, 0.5, 1.5}, {9, 9, 9}, 5);
  rig.addSurfel({0, 0, 3}, {0, 0, 1});
  carry(rig);
  EXPECT_EQ(rig.w.surface.surfels.position[0], (Vec3d{0, 0, 3}));
}

}  // namespace
}  // namespace thaw
