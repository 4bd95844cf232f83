// SPDX-License-Identifier: Apache-2.0
// Solids and bonds of one process: changes of the graph and data that the elastic step caches (several ranks:
// tests/mpi/bond_halo_test.cpp).
#include <gtest/gtest.h>

#include <cstring>

#include <map>
#include <set>

#include "core/solid/bonds/serial_bond_halo.hpp"
#include "tests/support/solid_body.hpp"

namespace thaw {
namespace {

TEST(IdTable, IsAMap) {
  IdTable table;
  std::map<std::uint64_t, std::uint32_t> oracle;
  EXPECT_EQ(table.find(3), IdTable::none);
  EXPECT_FALSE(table.erase(3));
  for (std::uint64_t n = 0; n < 20000; n++) {
    const std::uint64_t id = spreadBits(n) % 500 << (n % 2 ? 40 : 0);
    if (spreadBits(n + 1) % 3 == 0) {
      EXPECT_EQ(table.erase(id), oracle.erase(id) > 0);
    } else {
      table.insert(id, static_cast<std::uint32_t>(n));
      oracle[id] = static_cast<std::uint32_t>(n);
    }
    ASSERT_EQ(table.size(), oracle.size());
    const std::uint64_t other = spreadBits(n + 2) % 500;
    const auto at = oracle.find(other);
    ASSERT_EQ(table.find(other), at == oracle.end() ? IdTable::none : at->second);
  }
}

/// A lattice of solid particles, bonded over the same distance.
struct Lattice {
  Scene scene;
  Modules modules;
  CellGrid grid;
  Continuum p;
  Solids s;
  Bonds b;
  ElasticWork work;
  SerialBondHalo halo;
  std::vector<Vec3d> points;

  explicit Lattice(Precision precision = Precision::Single) : points(test::lattice({5, 4, 3}, 0.1)) {
    scene.spacing = 0.1;
    scene.numerics.elasticPrecision = precision;
    scene.materials = {test::elasticMaterial()};
    modules.solid = modules.freezing = true;
    p.activate(p.id);
    p.activate(p.phase);
    p.activate(p.material);
    p.activate(p.position);
    activateSolidFields(p, s, b, work, {scene, modules, grid});
    p.resize(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); i++) {
      p.id[i] = 1000 + i;
      p.position[i] = points[i];
      p.solidIndex[i] = noSolid;
    }
    rebuildBonds({}, true);
    rebuildBonds(bondsAround(0), false);
  }
  std::vector<BondRequest> bondsAround(std::size_t from) const {
    std::vector<BondRequest> q;
    for (std::size_t i = from; i < points.size(); i++)
      for (std::size_t j = 0; j < points.size(); j++) {
        const Vec3d x = points[j] - points[i];
        if (i != j && p.solidIndex[i] != noSolid && dot(x, x) < 0.16 * 0.16)
          q.push_back({p.solidIndex[i], p.id[j], x, -x, 1.0 / (1 + dot(x, x))});
      }
    return q;
  }
  bool rebuildBonds(const std::vector<BondRequest>& requests, bool changed) {
    const bool any = halo.rebuildBonds(p, s, b, {requests, changed});
    if (any) refreshReference(work, s, b, false);
    halo.graph().check({p, s, b});
    return any;
  }
  std::set<std::uint64_t> bondedTo(std::uint32_t solidIndex) const {
    std::set<std::uint64_t> ids;
    for (int k = 0; k < b.capacity; k++)
      if (b.hasBond(solidIndex, k)) ids.insert(s.id[b.neighbour[b.at(solidIndex, k)]]);
    return ids;
  }
  /// Checks that incremental updates equal a full computation.
  void expectFreshWork() {
    ElasticWork fresh;
    Continuum p2;
    Solids s2;
    Bonds b2;
    activateSolidFields(p2, s2, b2, fresh, {scene, modules, grid});
    const std::vector<Sym3d> inverse(s.momentInverse.data(), s.momentInverse.data() + s.owned);
    refreshReference(fresh, s, b, true);
    for (std::size_t i = 0; i < s.owned; i++)
      ASSERT_EQ(0, std::memcmp(&inverse[i], &s.momentInverse[i], sizeof(Sym3d)));
    EXPECT_EQ(fresh.inner, work.inner);
    EXPECT_EQ(fresh.boundary, work.boundary);
    EXPECT_EQ(fresh.bondCount, work.bondCount);
    EXPECT_EQ(fresh.rank, work.rank);
    EXPECT_EQ(fresh.singularLanes, work.singularLanes);
    EXPECT_EQ(fresh.perTrace, work.perTrace);
    EXPECT_EQ(fresh.perWeight, work.perWeight);
  }
};

TEST(BondGraph, FollowsMeltingAndFreezing) {
  Lattice l;
  EXPECT_FALSE(l.rebuildBonds({}, false));
  const std::size_t n = l.points.size();
  l.p.phase[7] = l.p.phase[20] = l.p.phase[59] = Liquid;
  const std::set<std::uint64_t> before = l.bondedTo(l.p.solidIndex[8]);
  EXPECT_EQ(before.count(1007), 1u);
  EXPECT_TRUE(l.rebuildBonds({}, true));
  EXPECT_EQ(l.s.owned, n - 3);
  EXPECT_EQ(l.p.solidIndex[7], noSolid);
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[8]).count(1007), 0u);
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[8]).size(), before.size() - 1);
  l.expectFreshWork();

  l.p.phase[20] = Solid;
  l.rebuildBonds({}, true);
  EXPECT_EQ(l.s.owned, n - 2);
  EXPECT_EQ(l.s.volume[l.p.solidIndex[20]], 0);
  EXPECT_TRUE(l.bondedTo(l.p.solidIndex[20]).empty());
  l.expectFreshWork();
  l.rebuildBonds({{l.p.solidIndex[20], 1021, {0.1, 0, 0}, {-0.1, 0, 0}, 2},
                  {l.p.solidIndex[21], 1020, {-0.1, 0, 0}, {0.1, 0, 0}, 2},
                  {l.p.solidIndex[20], 1007, {1, 0, 0}, {}, 3}},
                 false);
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[20]), std::set<std::uint64_t>{1021});  // 7 is liquid
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[21]).count(1020), 1u);
  l.expectFreshWork();
}

TEST(BondGraph, BrokenBondsAreRemoved) {
  Lattice l;
  const std::uint32_t solidIndex = l.p.solidIndex[30];
  const std::size_t at = l.b.at(solidIndex, 2);
  const std::uint32_t other = l.b.neighbour[at];
  for (int k = 0; k < l.b.capacity; k++)
    if (l.b.hasBond(other, k) && l.b.neighbour[l.b.at(other, k)] == solidIndex) l.b.cut(other, k);
  const std::uint32_t next = l.b.neighbour[l.b.at(solidIndex, 3)];
  l.b.cut(solidIndex, 2);
  EXPECT_TRUE(l.rebuildBonds({}, false));
  EXPECT_FALSE(l.b.broken);
  EXPECT_EQ(l.b.neighbour[at], next);  // the order of the others is kept
  EXPECT_EQ(l.bondedTo(solidIndex).count(l.s.id[other]), 0u);
  EXPECT_EQ(l.bondedTo(other).count(1030), 0u);
  l.expectFreshWork();
}

TEST(BondGraph, GrowsWithTheNumberOfBonds) {
  Lattice l(Precision::Double);
  std::vector<BondRequest> q;
  for (std::size_t j = 0; j < l.points.size(); j++)
    if (j != 5) {
      const Vec3d x = l.points[j] - l.points[5];
      q.push_back({l.p.solidIndex[5], l.p.id[j], x, -x, 1});
      q.push_back({l.p.solidIndex[j], l.p.id[5], -x, x, 1});
    }
  l.rebuildBonds(q, false);
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[5]).size(), l.points.size() - 1);
  EXPECT_EQ(l.bondedTo(l.p.solidIndex[6]).count(1005), 1u);
  l.expectFreshWork();
}

TEST(BondGraph, RestoresAllBondsFromRecords) {
  Lattice l;
  SolidRecords records;
  std::vector<std::set<std::uint64_t>> before;
  for (std::size_t i = 0; i < l.points.size(); i++) {
    l.s.volume[l.p.solidIndex[i]] = 3.0 + static_cast<double>(i);
    appendRecord(l.s, l.b, l.p.solidIndex[i], records);
    before.push_back(l.bondedTo(l.p.solidIndex[i]));
    l.p.phase[i] = Liquid;
  }
  l.rebuildBonds({}, true);
  EXPECT_EQ(l.s.size(), 0u);
  l.expectFreshWork();
  std::fill_n(l.p.phase.data(), l.p.owned, std::uint8_t(Solid));
  l.halo.adopt(std::move(records.bytes));
  EXPECT_TRUE(l.rebuildBonds({}, false));
  for (std::size_t i = 0; i < l.points.size(); i++) {
    EXPECT_EQ(l.bondedTo(l.p.solidIndex[i]), before[i]);
    EXPECT_EQ(l.s.volume[l.p.solidIndex[i]], 3.0 + static_cast<double>(i));
  }
  l.expectFreshWork();
}

TEST(BondGraph, BrokenRecordsAreRefused) {
  Lattice l;
  SolidRecords records;
  appendRecord(l.s, l.b, 0, records);
  records.bytes.resize(records.bytes.size() - 5);
  SerialBondHalo fresh;
  fresh.adopt(records.bytes);
  Solids none;
  l.s.resize(l.s.owned, 0);
  l.s.resize(0, 0);
  EXPECT_THROW(fresh.rebuildBonds(l.p, l.s, l.b, {}), std::runtime_error);
}

TEST(BondGraph, RowsAddedByOthersAreRefused) {
  Lattice l;
  l.s.resize(l.s.owned + 1, 0);
  l.s.particle[l.s.owned - 1] = 0;
  EXPECT_THROW(l.halo.rebuildBonds(l.p, l.s, l.b, {{}, true}), std::logic_error);
}

}  // namespace
}  // namespace thaw
