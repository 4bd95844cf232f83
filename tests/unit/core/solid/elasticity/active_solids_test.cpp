// SPDX-License-Identifier: Apache-2.0
// Solids inside rigid pieces are left out of the elastic sums (active_solids.hpp). Forces of other solids,
// and force, torque and energy of pieces, are still those of all sums.
#include "core/solid/elasticity/active_solids.hpp"

#include <gtest/gtest.h>

#include "tests/support/solid_body.hpp"

namespace thaw {
namespace {

using namespace test;

Vec3d stretched(const Vec3d& x) {
  return {1.1 * x.x + 0.05 * x.y, 0.95 * x.y + 0.3 * x.z * x.x, x.z + 0.2 * x.x * x.x};
}

struct Load {
  Vec3d force{}, torque{};
};

Load loadOf(const SolidBody& b, const SolidPieces& pieces, std::uint64_t piece) {
  Load sum;
  for (std::size_t s = 0; s < b.solids.owned; s++) {
    if (pieces.piece[s] != piece) continue;
    sum.force += b.solids.force[s];
    sum.torque += cross(b.solids.position[s], b.solids.force[s]);
  }
  return sum;
}

class ActiveSolids : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(ActiveSolids, SumsAreThoseOfAllSolids) {
  const auto [law, freezing] = GetParam();
  const std::vector<Vec3d> points = lattice({14, 5, 5}, 0.1, 0.05);
  Material m = elasticMaterial(1e5, 0.3);
  m.law.name = law;
  m.damping = 3;
  BodyOptions options;
  options.freezing = freezing;
  const auto all = makeBody(points, {m}, options), some = makeBody(points, {m}, options);
  SolidPieces pieces;
  pieces.resize(points.size(), 0);
  for (std::size_t s = 0; s < points.size(); s++)
    pieces.piece[s] = points[s].x < 0.55 ? 4 : points[s].x > 0.95 ? 9 : 0;
  for (SolidBody* b : {all.get(), some.get()}) {
    b->solids.activate(b->solids.velocity);
    moveAll(*b, points, stretched);
    computeForces(*b);
  }
  chooseActiveSolids(some->work, some->solids, some->bonds, pieces);
  std::size_t passive = 0;
  for (std::size_t s = 0; s < points.size(); s++) passive += isPassive(some->work, s);
  EXPECT_GT(passive, 100u);
  // The pieces rotate, and the solid between them deforms.
  const Mat3d turn = rotation({1, 2, 3}, 0.4);
  for (SolidBody* b : {all.get(), some.get()}) {
    b->step.dt = 1e-3;
    for (std::size_t s = 0; s < points.size(); s++) {
      const Vec3d x = stretched(points[s]), spin{0.1, 0.2, -0.3};
      b->solids.position[s] = pieces.piece[s] == 4   ? turn * x
                              : pieces.piece[s] == 9 ? turn * x + Vec3d{0.03, 0, 0}
                                                     : turn * x + 0.01 * noise3(s, 3);
      b->solids.velocity[s] = pieces.piece[s] ? cross(spin, b->solids.position[s]) : noise3(s, 5);
    }
    computeForces(*b);
  }
  const double scale = forceScale(*all);
  for (std::size_t s = 0; s < points.size(); s++) {
    EXPECT_NEAR(some->solids.energy[s], all->solids.energy[s], 1e-12 * totalEnergy(*all));
    if (pieces.piece[s] == 0) {
      EXPECT_LT(length(some->solids.force[s] - all->solids.force[s]), 1e-14 * scale);
    }
  }
  for (const std::uint64_t piece : {4u, 9u}) {
    const Load a = loadOf(*all, pieces, piece), b = loadOf(*some, pieces, piece);
    EXPECT_GT(length(a.force), 1e-6 * scale);
    EXPECT_LT(length(a.force - b.force), 1e-12 * scale);
    EXPECT_LT(length(a.torque - b.torque), 1e-12 * scale);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ActiveSolids,
                         testing::Combine(testing::Values("green", "neo-hookean", "corotated"),
                                          testing::Bool()));

TEST(ActiveSolids, WithoutPiecesAllAreActive) {
  const std::vector<Vec3d> points = lattice({4, 4, 4}, 0.1);
  const auto b = makeBody(points, {elasticMaterial()});
  SolidPieces pieces;
  pieces.resize(points.size(), 0);
  chooseActiveSolids(b->work, b->solids, b->bonds, pieces);
  EXPECT_TRUE(activeSolidsKnown(b->work, b->solids));
  EXPECT_TRUE(anyActiveSolid(b->work, b->solids));
  EXPECT_FALSE(b->work.sleeping);
  for (std::size_t s = 0; s < points.size(); s++) pieces.piece[s] = 1;
  chooseActiveSolids(b->work, b->solids, b->bonds, pieces);
  EXPECT_FALSE(anyActiveSolid(b->work, b->solids));
  forgetActiveSolids(b->work);
  EXPECT_FALSE(activeSolidsKnown(b->work, b->solids));
}

// A solid that arrives from another rank while it is passive has no F, unlike one that stayed.
TEST(ActiveSolids, SolidsThatBecomeActiveHaveTheirDeformation) {
  const std::vector<Vec3d> points = lattice({5, 5, 5}, 0.1, 0.05);
  const auto b = makeBody(points, {elasticMaterial()});
  moveAll(*b, points, stretched);
  computeForces(*b);
  const std::vector<Mat3d> deformed(b->solids.deformation.data(),
                                    b->solids.deformation.data() + points.size());
  SolidPieces pieces;
  pieces.resize(points.size(), 0);
  for (std::size_t s = 0; s < points.size(); s++) pieces.piece[s] = 1;
  for (std::size_t s = 0; s < points.size(); s++) b->solids.deformation[s] = {};
  chooseActiveSolids(b->work, b->solids, b->bonds, pieces);
  for (std::size_t s = 0; s < points.size(); s++) pieces.piece[s] = points[s].x < 0.25 ? 1 : 0;
  chooseActiveSolids(b->work, b->solids, b->bonds, pieces);
  std::size_t active = 0;
  for (std::size_t s = 0; s < points.size(); s++) {
    if (isPassive(b->work, s)) continue;
    active++;
    for (int r = 0; r < 3; r++)
      EXPECT_LT(length(b->solids.deformation[s].row[r] - deformed[s].row[r]), 1e-12) << "solidIndex " << s;
  }
  EXPECT_GT(active, 50u);
  EXPECT_LT(active, points.size());
}

}  // namespace
}  // namespace thaw
