// SPDX-License-Identifier: Apache-2.0
// A body in two parts with manually exchanged remote rows gives the bits of the whole body, through plastic
// flow, re-reference, fracture and damping.
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// The solids of `whole`, still at rest, with these ids, and remote rows for their bonds.
std::unique_ptr<SolidBody> partOf(const SolidBody& whole, const std::vector<std::size_t>& ids) {
  auto part = std::make_unique<SolidBody>();
  SolidBody& b = *part;
  b.scene = whole.scene;
  b.modules = whole.modules;
  b.grid = whole.grid;
  activateSolidFields(b.particles, b.solids, b.bonds, b.work, {b.scene, b.modules, b.grid});
  std::map<std::size_t, std::uint32_t> row;
  for (const std::size_t id : ids) row.emplace(id, static_cast<std::uint32_t>(row.size()));
  std::vector<std::size_t> rows = ids;
  for (const std::size_t id : ids)
    for (int k = 0; k < whole.bonds.capacity; k++) {
      const std::size_t other = whole.bonds.neighbour[whole.bonds.at(id, k)];
      if (row.emplace(other, static_cast<std::uint32_t>(row.size())).second) rows.push_back(other);
    }
  b.solids.resize(ids.size(), rows.size() - ids.size());
  for (std::size_t s = 0; s < rows.size(); s++) {
    b.solids.id[s] = rows[s];
    b.solids.material[s] = whole.solids.material[rows[s]];
    if (b.solids.reference.active) b.solids.reference[s] = whole.solids.reference[rows[s]];
    if (s < ids.size()) b.solids.volume[s] = whole.solids.volume[rows[s]];
  }
  b.bonds.capacity = whole.bonds.capacity;
  const std::size_t room = (ids.size() + lanes - 1) / lanes * lanes *
                           static_cast<std::size_t>(b.bonds.capacity);
  b.bonds.neighbour.assign(room, 0xffffffu);  // entries after the last solid must not matter
  b.bonds.eachReal([&](BondReals& r) { r.assign(room, 1e30); });
  for (std::size_t s = 0; s < ids.size(); s++)
    for (int k = 0; k < b.bonds.capacity; k++) {
      const std::size_t to = b.bonds.at(s, k), from = whole.bonds.at(ids[s], k);
      const Bonds& w = whole.bonds;
      BondRecord r{};
      if (w.vectors)
        r = {0, {w.x[from], w.y[from], w.z[from]}, {w.rx[from], w.ry[from], w.rz[from]}, w.weight[from]};
      putBond(b.bonds, to, row.at(w.neighbour[from]), r);
    }
  refreshReference(b.work, b.solids, b.bonds, true);
  return part;
}

/// Copies owned rows of `from` to remote rows of `to`.
void exchange(SolidBody& from, SolidBody& to, ColumnList (*columns)(Solids&)) {
  std::map<std::uint64_t, std::size_t> owner;
  for (std::size_t s = 0; s < from.solids.owned; s++) owner[from.solids.id[s]] = s;
  const ColumnList ours = columns(from.solids), theirs = columns(to.solids);
  const std::span<AnyColumn*const> source = ours, target = theirs;
  for (std::size_t c = 0; c < source.size(); c++)
    for (std::size_t s = to.solids.owned; s < to.solids.size(); s++)
      std::memcpy(target[c]->bytes.data() + s * target[c]->elementBytes,
                  source[c]->bytes.data() + owner.at(to.solids.id[s]) * source[c]->elementBytes,
                  source[c]->elementBytes);
}

struct Counts {
  std::int64_t broken = 0, rereferenced = 0;
};

void step(std::vector<SolidBody*> parts, Counts& counts) {
  const auto swap = [&](auto columns) {
    if (parts.size() == 2) exchange(*parts[0], *parts[1], columns), exchange(*parts[1], *parts[0], columns);
  };
  ExactSum jump;
  for (SolidBody* b : parts)
    computeDeformationAndStress(b->work, b->solids, b->bonds, b->step, SolidPart::Inner);
  swap(remoteColumnsBeforeDeformation);
  for (SolidBody* b : parts)
    computeDeformationAndStress(b->work, b->solids, b->bonds, b->step, SolidPart::Boundary);
  for (SolidBody* b : parts) counts.broken += breakBonds(b->work, b->solids, b->bonds, b->step, jump);
  for (SolidBody* b : parts) counts.rereferenced += rereference(b->work, b->solids, b->bonds, b->step, jump);
  for (SolidBody* b : parts) computeElasticForces(b->work, b->solids, b->bonds, b->step, SolidPart::Inner);
  swap(remoteColumnsBeforeForces);
  for (SolidBody* b : parts) computeElasticForces(b->work, b->solids, b->bonds, b->step, SolidPart::Boundary);
}

// Groups whose bonds have one reference skip the inverse map (ElasticWork::ownFrames). The grouping depends
// on the ranks, so it may not change any bit, for any deformation.
TEST(SolidParts, SkippedInverseMapChangesNoBit) {
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    BodyOptions options;
    options.precision = precision;
    options.freezing = true;
    const auto body = makeBody(lattice({7, 6, 5}, 0.1, 0.1), {elasticMaterial()}, options);
    SolidBody& b = *body;
    ASSERT_TRUE(b.bonds.twoFrames);
    // three spacings: bonds of any length and direction
    for (std::size_t i = 0; i < b.solids.owned; i++) b.solids.position[i] += 0.3 * noise3(i, 11);
    std::vector<Vec3d> force[2];
    for (const std::uint8_t reads : {0, 1}) {
      std::fill(b.work.ownFrames.begin(), b.work.ownFrames.end(), reads);
      computeForces(b);
      force[reads].assign(b.solids.force.data(), b.solids.force.data() + b.solids.owned);
    }
    for (std::size_t i = 0; i < b.solids.owned; i++)
      ASSERT_EQ(std::memcmp(&force[0][i], &force[1][i], sizeof(Vec3d)), 0) << i;
  }
}

}  // namespace

TEST(SolidParts, TwoPartsHaveTheBitsOfTheWhole) {
  const auto points = lattice({9, 5, 9}, 0.1, 0.2);
  Material m = elasticMaterial(1e5, 0.3), other = elasticMaterial(3e5, 0.2);
  m.yieldStrain = {0.02, 0.02};
  m.creepRate = {never, never};
  other.breakStretch = 1.3;
  other.damping = 3;
  other.law.name = "corotated";
  Material third = elasticMaterial(2e5, 0.25);
  third.law.name = "neo-hookean";
  third.volumeStiffness = 1e5;
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    BodyOptions options;
    options.precision = precision;
    // some groups of 8 solids have one material and some several, and the parts are grouped differently
    options.material = [](std::size_t i) { return i / 45 > 5 ? 1 : i / 45 > 3 ? 2 : i % 45 / 9 > 2 ? 1 : 0; };
    const auto whole = makeBody(points, {m, other, third}, options);
    std::vector<std::size_t> near, far;
    for (std::size_t s = 0; s < points.size(); s++)
      (points[s].z + 0.1 * points[s].x < 0.45 ? near : far).push_back(s);
    const auto a = partOf(*whole, near), b = partOf(*whole, far);
    ASSERT_FALSE(a->work.boundary.empty());
    ASSERT_FALSE(a->work.inner.empty());
    Counts one, two;
    for (int n = 0; n < 4; n++) {
      for (SolidBody* body : {whole.get(), a.get(), b.get()}) {
        body->step.dt = 1e-3;
        for (std::size_t s = 0; s < body->solids.owned; s++) {
          const std::size_t id = body->solids.id[s];
          const Vec3d& x = points[id];
          const double t = 0.25 * n;
          body->solids.position[s] = Vec3d{x.x + t * 1.2 * x.x * x.x, x.y * (1 - 0.2 * t),
                                           x.z + t * x.x * x.y} +
                                     0.003 * noise3(id, 5);
          body->solids.velocity[s] = noise3(id, 6);
        }
      }
      step({whole.get()}, one);
      step({a.get(), b.get()}, two);
      for (SolidBody* body : {a.get(), b.get()})
        for (std::size_t s = 0; s < body->solids.owned; s++) {
          const std::size_t id = body->solids.id[s];
          EXPECT_TRUE(body->solids.force[s] == whole->solids.force[id]) << n << ' ' << id;
          EXPECT_EQ(body->solids.energy[s], whole->solids.energy[id]);
          EXPECT_EQ(body->solids.dissipated[s], whole->solids.dissipated[id]);
          EXPECT_EQ(body->solids.volume[s], whole->solids.volume[id]);
        }
    }
    EXPECT_GT(one.broken, 10);
    EXPECT_GT(one.rereferenced, 10);
    EXPECT_EQ(one.broken, two.broken);
    EXPECT_EQ(one.rereferenced, two.rereferenced);
  }
}
