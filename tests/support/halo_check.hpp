// SPDX-License-Identifier: Apache-2.0
// Cell halos against brute force: every rank computes all particles (functions of the id) and its expected
// content.
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/sort.hpp"
#include "tests/support/hashed.hpp"

namespace thaw::test {

/// A grid of cells of edge 0.5 x 0.6 x 0.7. Bit a of `periodic` makes axis a periodic.
inline CellGrid plainGrid(const Vec3i& cells, int periodic) {
  CellGrid g;
  g.origin = {-1, 2, 0.25};
  g.edge = {0.5, 0.6, 0.7};
  g.cells = cells;
  g.support = 0.5;
  for (int a = 0; a < 3; a++) {
    g.periodic[a] = (periodic >> a & 1) != 0;
    g.period[a] = cells[a] * g.edge[a];
  }
  return g;
}

/// Positions of all particles, which move with `time`. The order of ids is unrelated to positions.
struct Cloud {
  CellGrid grid;
  std::uint64_t number = 0;
  bool oneCell = false;
  int time = 0;

  Vec3d position(std::uint64_t id) const {
    Vec3d x;
    for (int a = 0; a < 3; a++) {
      double u = hashed(97 * id + static_cast<std::uint64_t>(a) + 1);
      if (time > 0) u += 0.11 * time * (hashed(31 * id + static_cast<std::uint64_t>(a) + 7) - 0.3);
      u -= std::floor(u);
      const double cells = grid.cells[a];
      if (oneCell) u = (std::floor(0.6 * cells) + u) / cells;
      x[a] = grid.origin[a] + grid.edge[a] * cells * u;
    }
    return x;
  }
  static Vec3d velocity(std::uint64_t id) { return {hashed(id), hashed(id + 1000), static_cast<double>(id)}; }
  Vec3i cell(std::uint64_t id) const { return cellOf(grid, position(id)); }
};

/// Particles, sorted cells and a halo on one rank.
struct HaloRig {
  Cloud cloud;
  CellHalo& halo;
  Reducer& all;
  Continuum particles;
  CellTable cells;
  SortBuffers sort;

  HaloRig(const Cloud& cloud, CellHalo& halo, Reducer& all) : cloud(cloud), halo(halo), all(all) {
    Continuum& p = particles;
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.id, &p.position, &p.velocity, &p.material,
                                                          &p.clamped, &p.liquid, &p.cell, &p.nextCell,
                                                          &p.solidIndex, &p.relativeDensity})
      p.activate(*c);
  }
  /// The initial particles of a rank, which need not be the ones it owns. spread: over all ranks, else all on
  /// the last one.
  void start(bool spread) {
    std::vector<std::uint64_t> mine;
    for (std::uint64_t id = 0; id < cloud.number; id++)
      if ((spread ? static_cast<int>(id % static_cast<std::uint64_t>(all.size())) : all.size() - 1) ==
          all.rank())
        mine.push_back(id);
    particles.resize(mine.size(), 0);
    for (std::size_t i = 0; i < mine.size(); i++) {
      particles.id[i] = mine[i];
      particles.velocity[i] = Cloud::velocity(mine[i]);
      particles.material[i] = static_cast<std::uint16_t>(mine[i] % 1000);
      particles.clamped[i] = static_cast<std::uint8_t>(mine[i] % 3);
      particles.liquid[i] = static_cast<float>(hashed(mine[i]));
      particles.cell[i] = ~std::uint64_t{0};  // no cell yet, so that the sort treats the row as moved
      particles.solidIndex[i] = static_cast<std::uint32_t>(mine[i]);
    }
    place();
  }
  void place() {
    for (std::size_t i = 0; i < particles.owned; i++) particles.position[i] = cloud.position(particles.id[i]);
  }
  /// Migration, sort and ghosts, as in a step.
  void exchange() {
    computeCellKeys(cloud.grid, particles);
    const Migration m = halo.migrate(particles, {particles.nextCell.data(), particles.owned});
    ASSERT_EQ(m.departed.size(), m.departedTo.size());
    for (std::size_t k = 0; k < m.departed.size(); k++) {
      ASSERT_LT(m.departed[k], particles.owned - m.arrivals);
      ASSERT_FALSE(halo.owns(particles.nextCell[m.departed[k]]));
      ASSERT_NE(m.departedTo[k], all.rank());
      ASSERT_TRUE(k == 0 || m.departed[k - 1] < m.departed[k]);
    }
    for (std::size_t i = particles.owned - m.arrivals; i < particles.owned; i++) {
      ASSERT_EQ(particles.solidIndex[i], noSolid);
      ASSERT_EQ(particles.relativeDensity[i], 0);
      ASSERT_EQ(particles.cell[i], 0u);
    }
    computeCellKeys(cloud.grid, particles);
    sortByCell(particles, m, sort, cells);
    std::vector<AnyColumn*> columns{&particles.id, &particles.position, &particles.clamped,
                                    &particles.material};
    halo.beginGhosts(particles, cells, columns);
    halo.finishGhosts(particles, cells);
  }
  /// Checks that every particle is owned once, by the owner of its cell, with its values.
  void checkOwned() {
    std::vector<std::int64_t> owners(cloud.number, 0);
    for (std::size_t i = 0; i < particles.owned; i++) {
      const std::uint64_t id = particles.id[i];
      ASSERT_LT(id, cloud.number);
      owners[id]++;
      EXPECT_TRUE(halo.owns(cellKey(cloud.cell(id))));
      EXPECT_TRUE(particles.position[i] == cloud.position(id));
      EXPECT_TRUE(particles.velocity[i] == Cloud::velocity(id));
      EXPECT_EQ(particles.material[i], id % 1000);
      EXPECT_EQ(particles.clamped[i], id % 3);
      EXPECT_EQ(particles.liquid[i], static_cast<float>(hashed(id)));
    }
    all.sum(owners);
    for (std::uint64_t id = 0; id < cloud.number; id++) ASSERT_EQ(owners[id], 1) << "particle " << id;
  }
  bool touchesOurs(const Vec3i& c) const {
    Vec3i d, n = cloud.grid.cells;
    for (d.z = -1; d.z <= 1; d.z++)
      for (d.y = -1; d.y <= 1; d.y++)
        for (d.x = -1; d.x <= 1; d.x++) {
          const Vec3i b = c + d;
          if (b.x >= 0 && b.y >= 0 && b.z >= 0 && b.x < n.x && b.y < n.y && b.z < n.z &&
              halo.owns(cellKey(b)))
            return true;
        }
    return false;
  }
  /// Checks that ghosts are exactly the particles in cells around the owned ones, images included, and that
  /// cells are ordered, contiguous and sorted by id.
  void checkGhosts() {
    const CellGrid& g = cloud.grid;
    std::map<std::pair<std::uint64_t, std::uint64_t>, Vec3d> expected;  // (key, id) -> position
    for (std::uint64_t id = 0; id < cloud.number; id++) {
      const Vec3i c = cloud.cell(id);
      Vec3i s;
      for (s.z = -1; s.z <= 1; s.z++)
        for (s.y = -1; s.y <= 1; s.y++)
          for (s.x = -1; s.x <= 1; s.x++) {
            if ((s.x != 0 && !g.periodic[0]) || (s.y != 0 && !g.periodic[1]) || (s.z != 0 && !g.periodic[2]))
              continue;
            if (s == Vec3i{} && halo.owns(cellKey(c))) continue;
            const Vec3i seen{c.x + s.x * g.cells.x, c.y + s.y * g.cells.y, c.z + s.z * g.cells.z};
            if (!touchesOurs(seen)) continue;
            Vec3d x = cloud.position(id);
            x += Vec3d{s.x * g.period.x, s.y * g.period.y, s.z * g.period.z};
            expected[{cellKey(seen), id}] = x;
          }
    }
    EXPECT_EQ(particles.ghosts, expected.size());
    std::vector<int> listed(particles.size(), 0);
    std::size_t ownedCells = 0;
    for (std::size_t c = 0; c < cells.key.size(); c++) {
      ASSERT_TRUE(c == 0 || cells.key[c - 1] < cells.key[c]);
      ASSERT_GT(cells.count[c], 0u);
      const bool ours = cells.first[c] < particles.owned;
      ownedCells += ours ? 1 : 0;
      for (std::uint32_t k = 0; k < cells.count[c]; k++) {
        const std::size_t row = cells.first[c] + k;
        ASSERT_LT(row, particles.size());
        listed[row]++;
        ASSERT_TRUE(k == 0 || particles.id[row - 1] < particles.id[row]);
        if (ours) {
          EXPECT_EQ(cells.key[c], particles.cell[row]);
          continue;
        }
        const auto at = expected.find({cells.key[c], particles.id[row]});
        ASSERT_NE(at, expected.end()) << "unexpected ghost: " << particles.id[row];
        EXPECT_TRUE(particles.position[row] == at->second);
        EXPECT_EQ(particles.clamped[row], particles.id[row] % 3);
        EXPECT_EQ(particles.material[row], particles.id[row] % 1000);
        expected.erase(at);
      }
    }
    EXPECT_TRUE(expected.empty()) << expected.size() << " ghosts are missing";
    EXPECT_EQ(ownedCells, cells.ownedCells);
    for (const int n : listed) ASSERT_EQ(n, 1);
  }
  /// Checks that inner cells are those without a ghost neighbour.
  void checkInner() {
    const CellGrid& g = cloud.grid;
    for (std::size_t c = 0; c < cells.key.size(); c++) {
      if (!halo.owns(cells.key[c])) continue;
      const Vec3i cell = cellOfKey(cells.key[c]);
      bool alone = true;
      Vec3i d;
      for (d.z = -1; d.z <= 1; d.z++)
        for (d.y = -1; d.y <= 1; d.y++)
          for (d.x = -1; d.x <= 1; d.x++) {
            const Vec3i b = cell + d;
            bool exists = true, inside = true;
            for (int a = 0; a < 3; a++) {
              const bool in = b[a] >= 0 && b[a] < g.cells[a];
              inside = inside && in;
              exists = exists && (in || g.periodic[a]);
            }
            if (exists && (!inside || !halo.owns(cellKey(b)))) alone = false;
          }
      EXPECT_EQ(halo.inner(cells.key[c]), alone);
    }
  }
  /// Checks that changed columns reach the ghosts and that switched-off columns are left out.
  void checkRefresh() {
    Continuum& p = particles;
    for (int round = 0; round < 2; round++) {
      for (std::size_t i = 0; i < p.owned; i++) {
        p.relativeDensity[i] = static_cast<float>(p.id[i] % 4096) + 0.5f * static_cast<float>(round);
        p.velocity[i] = Cloud::velocity(p.id[i]) + Vec3d{1.0 + round, 0, 0};
      }
      std::vector<AnyColumn*> columns{&p.relativeDensity, &p.freeSurfaceIndicator, &p.velocity};
      halo.beginRefresh(p, columns);
      halo.finishRefresh(p);
      for (std::size_t i = p.owned; i < p.size(); i++) {
        EXPECT_EQ(p.relativeDensity[i],
                  static_cast<float>(p.id[i] % 4096) + 0.5f * static_cast<float>(round));
        EXPECT_TRUE(p.velocity[i] == (Cloud::velocity(p.id[i]) + Vec3d{1.0 + round, 0, 0}));
      }
    }
    for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = Cloud::velocity(p.id[i]);
  }
  void checkAll() {
    exchange();
    checkOwned();
    checkGhosts();
    checkInner();
    checkRefresh();
  }
};

}  // namespace thaw::test
