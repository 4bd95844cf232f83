// SPDX-License-Identifier: Apache-2.0
#include "core/solid/bonds/bond_forming.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/solid/bonds/bond_entries.hpp"
#include "core/solid/bonds/bond_graph.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Neighbour lists of all pairs, in order of ids.
NeighbourLists allPairs(std::size_t n) {
  NeighbourLists lists;
  lists.groups = (n + 7) / 8;
  lists.dummy = static_cast<std::uint32_t>(n);
  lists.self.assign(lists.groups * 8, lists.dummy);
  for (std::size_t g = 0; g < lists.groups; g++) {
    lists.first.push_back(lists.list.size());
    lists.count.push_back(static_cast<std::uint32_t>(n));
    for (std::size_t j = 0; j < n; j++)
      for (std::size_t l = 0; l < 8; l++)
        lists.list.push_back(2 * (j == g * 8 + l ? lists.dummy : static_cast<std::uint32_t>(j)));
  }
  for (std::size_t i = 0; i < n; i++) lists.self[i] = static_cast<std::uint32_t>(i);
  return lists;
}

void fillParticles(SolidBody& b, const std::vector<Vec3d>& points) {
  Continuum& p = b.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.id), static_cast<AnyColumn*>(&p.position),
                       static_cast<AnyColumn*>(&p.phase), static_cast<AnyColumn*>(&p.body),
                       static_cast<AnyColumn*>(&p.material)})
    p.activate(*c);
  p.resize(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); i++) {
    p.id[i] = i;
    p.position[i] = points[i];
    p.solidIndex[i] = static_cast<std::uint32_t>(i);
    b.solids.particle[i] = static_cast<std::uint32_t>(i);
  }
}

/// Adds requested bonds as BondHalo::rebuildBonds does.
void addBonds(SolidBody& b, const std::vector<BondRequest>& requests) {
  Bonds& bonds = b.bonds;
  std::vector<std::vector<BondRequest>> of(b.solids.owned);
  for (std::size_t s = 0; s < b.solids.owned; s++)
    for (int k = 0; k < bonds.capacity; k++) {
      const std::size_t at = bonds.at(s, k);
      if (bonds.hasBond(s, k))
        of[s].push_back({static_cast<std::uint32_t>(s),
                         bonds.neighbour[at],
                         {bonds.x[at], bonds.y[at], bonds.z[at]},
                         {bonds.rx[at], bonds.ry[at], bonds.rz[at]},
                         bonds.weight[at]});
    }
  for (const BondRequest& r : requests) of[r.solidIndex].push_back(r);
  bonds.capacity = 0;
  for (const auto& list : of) bonds.capacity = std::max(bonds.capacity, static_cast<int>(list.size()));
  const std::size_t room = (b.solids.owned + 7) / 8 * 8 * static_cast<std::size_t>(bonds.capacity);
  bonds.neighbour.assign(room, 0);
  bonds.eachReal([&](BondReals& r) { r.assign(room, 0); });
  for (std::size_t s = 0; s < of.size(); s++)
    for (std::size_t k = 0; k < of[s].size(); k++) {
      const std::size_t at = bonds.at(s, static_cast<int>(k));
      const BondRequest& r = of[s][k];
      putBond(bonds, at, static_cast<std::uint32_t>(r.neighbourId), bondOf(r));
    }
  refreshReference(b.work, b.solids, b.bonds, true);
}

/// Checks that both ends request the same bond with the same bits.
void expectSymmetric(const std::vector<BondRequest>& requests) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, BondRequest> all;
  for (const BondRequest& r : requests) EXPECT_TRUE(all.insert({{r.solidIndex, r.neighbourId}, r}).second);
  for (const auto& [ends, r] : all) {
    const auto other = all.find({ends.second, ends.first});
    ASSERT_NE(other, all.end());
    EXPECT_TRUE(other->second.reference == r.reverse && other->second.reverse == r.reference &&
                other->second.weight == r.weight);
  }
}

BondForming forming(const SolidBody& b, BondRule rule) {
  BondForming f;
  f.rule = rule;
  f.support = b.work.support;
  f.touch = f.touchBodies = b.scene.spacing;
  f.periods = b.work.periods;
  f.materials = &b.scene.materials;
  return f;
}

}  // namespace

TEST(BondForming, StartBondsBodiesSeparately) {
  const auto points = lattice({6, 3, 3}, 0.1, 0.2);
  BodyOptions options;
  options.freezing = true;
  const auto b = makeBody(points, {elasticMaterial()}, options);
  fillParticles(*b, points);
  for (std::size_t i = 0; i < points.size(); i++) b->particles.body[i] = i % 6 >= 3;
  std::vector<BondRequest> requests;
  EXPECT_EQ(formBonds({b->particles, b->solids, b->bonds, allPairs(points.size())},
                      forming(*b, BondRule::Start), requests),
            0);
  expectSymmetric(requests);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < points.size(); i++)
    for (std::size_t j = 0; j < points.size(); j++)
      expected += i != j && b->particles.body[i] == b->particles.body[j] &&
                  length(points[j] - points[i]) < b->work.support;
  EXPECT_EQ(requests.size(), expected);
  for (const BondRequest& r : requests) EXPECT_TRUE(r.reverse == -r.reference);
}

TEST(BondForming, FreezingJoinsWithoutStressJump) {
  // the lower half is an old, deformed solid; the upper half freezes onto it
  const auto points = lattice({5, 5, 6}, 0.1, 0.2);
  const auto old = [&](std::size_t i) { return i < 75; };
  BodyOptions options;
  options.freezing = true;
  const auto b = makeBody(points, {elasticMaterial()}, options);
  for (std::size_t s = 0; s < points.size(); s++)
    for (int k = 0; k < b->bonds.capacity; k++)
      if (!old(s) || !old(b->bonds.neighbour[b->bonds.at(s, k)])) b->bonds.cut(s, k);
  refreshReference(b->work, b->solids, b->bonds, true);
  const Mat3d r = rotation({1, 2, 3}, 0.8), f{{{1.1, 0.1, 0}, {0, 0.9, 0}, {0.05, 0, 1}}};
  std::vector<Vec3d> now;
  for (std::size_t s = 0; s < points.size(); s++) now.push_back(r * (f * points[s]) + 0.005 * noise3(s, 1));
  moveAll(*b, now, [](const Vec3d& x) { return x; });
  computeForces(*b);
  const double energy = totalEnergy(*b);
  std::vector<Mat3d> before(b->solids.deformation.data(), b->solids.deformation.data() + points.size());
  fillParticles(*b, now);
  for (std::size_t i = 0; i < points.size(); i++) b->particles.justFrozen[i] = !old(i);
  prepareBondForming(b->particles, b->solids);
  std::vector<BondRequest> requests;
  formBonds({b->particles, b->solids, b->bonds, allPairs(points.size())}, forming(*b, BondRule::Freezing),
            requests);
  expectSymmetric(requests);
  for (const BondRequest& q : requests) EXPECT_FALSE(old(q.solidIndex) && old(q.neighbourId));
  addBonds(*b, requests);
  EXPECT_EQ(b->bonds.capacity > 0, true);
  computeForces(*b);
  const double after = totalEnergy(*b);
  double exact = 0;
  for (std::size_t s = 0; s < points.size(); s++) exact += solidEnergy(b->work, b->solids, b->bonds, s);
  EXPECT_NEAR(after, exact, 1e-12 * exact);
  for (std::size_t s = 0; s < points.size(); s++)
    EXPECT_LT(largest(b->solids.deformation[s] - (old(s) ? before[s] : identity3<double>())), 1e-10) << s;
  EXPECT_NEAR(totalEnergy(*b), energy, 0.2 * energy);  // the hourglass stiffness of the old end is
                                                       // redistributed
}

TEST(BondForming, WeldsOnlyAllowedBodies) {
  Material m = elasticMaterial(), weldable = elasticMaterial();
  weldable.weld = true;
  const std::vector<Vec3d> points{{0, 0, 0}, {0.09, 0, 0}, {0.18, 0, 0}, {0.31, 0, 0}};
  for (const bool weld : {false, true}) {
    BodyOptions options;
    options.freezing = true;
    const auto b = makeBody(points, {weld ? weldable : m}, options);
    b->bonds.weight.assign(b->bonds.weight.size(), 0);
    refreshReference(b->work, b->solids, b->bonds, true);
    computeForces(*b);
    fillParticles(*b, points);
    for (std::size_t i = 0; i < 4; i++) b->particles.body[i] = static_cast<std::uint16_t>(i);
    b->particles.justFrozen[3] = 1;
    prepareBondForming(b->particles, b->solids);
    std::vector<BondRequest> freezing, welding;
    // 2-3
    EXPECT_EQ(formBonds({b->particles, b->solids, b->bonds, allPairs(4)}, forming(*b, BondRule::Freezing),
                        freezing),
              weld ? 1 : 0);
    // 0-1 and 1-2 as well
    EXPECT_EQ(
        formBonds({b->particles, b->solids, b->bonds, allPairs(4)}, forming(*b, BondRule::Welding), welding),
        weld ? 3 : 0);
    expectSymmetric(welding);
    if (!weld) continue;
    addBonds(*b, welding);
    std::vector<BondRequest> again;
    b->particles.justFrozen[3] = 0;
    formBonds({b->particles, b->solids, b->bonds, allPairs(4)}, forming(*b, BondRule::Welding), again);
    EXPECT_TRUE(again.empty());
  }
}

TEST(BondForming, FrameOfInvertedParticleIsNotUsed) {
  const Vec3d x{0.1, 0.2, 0.3};
  EXPECT_TRUE(referenceIn(identity3<double>(), x) == x);
  EXPECT_TRUE(referenceIn({{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, x) == x);
  EXPECT_TRUE(referenceIn(Mat3d{}, x) == x);
}
