// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/lattice.hpp"

namespace thaw::test {

TEST(Sort, CellsAscendAndIdsAscendWithinACell) {
  Block b(12, 0.4);
  for (std::size_t i = 1; i < b.particles.owned; i++) {
    ASSERT_LE(b.particles.cell[i - 1], b.particles.cell[i]);
    if (b.particles.cell[i - 1] == b.particles.cell[i]) {
      ASSERT_LT(b.particles.id[i - 1], b.particles.id[i]);
    }
  }
}

/// Displacements in spacings: few particles change their cell (rows move in place), some do, or most (all are
/// merged).
class SortMoved : public testing::TestWithParam<double> {};

TEST_P(SortMoved, ParticlesAreMergedToTheSameOrderAsAFullSort) {
  Block b(14, 0.4);
  Continuum& p = b.particles;
  for (int round = 0; round < 20; round++) {
    for (std::size_t i = 0; i < p.owned; i++) {
      p.position[i].x += GetParam() * 0.01 *
                         (hashed(p.id[i] + 7919 * static_cast<std::uint64_t>(round)) - 0.5);
      p.mass[i] = static_cast<double>(p.id[i]);  // columns of all widths must follow
      p.velocity[i] = Vec3d{1, 2, 3} * p.mass[i];
      p.material[i] = static_cast<std::uint16_t>(p.id[i] % 999);
    }
    computeCellKeys(b.grid, p);
    Migration m;
    m.departed = {3, 17, static_cast<std::uint32_t>(p.owned - 1 - round)};
    const std::size_t last = p.owned;
    if (round % 3 == 0) {  // two arrive
      p.resize(last + 2, 0);
      m.arrivals = 2;
      for (std::size_t i = last; i < last + 2; i++) {
        p.id[i] = 100000 + 10 * static_cast<std::uint64_t>(round) + i;
        p.position[i] = p.position[i - 100 * static_cast<std::size_t>(round + 1)];
        p.mass[i] = static_cast<double>(p.id[i]);
        p.velocity[i] = Vec3d{1, 2, 3} * p.mass[i];
        p.material[i] = static_cast<std::uint16_t>(p.id[i] % 999);
      }
      computeCellKeys(b.grid, p, last, p.owned);
    }
    std::vector<std::pair<std::uint64_t, std::uint64_t>> expected;
    for (std::size_t i = 0; i < p.owned; i++)
      if (std::find(m.departed.begin(), m.departed.end(), i) == m.departed.end())
        expected.push_back({p.nextCell[i], p.id[i]});
    std::sort(expected.begin(), expected.end());
    sortByCell(p, m, b.sort, b.cells);
    ASSERT_EQ(p.owned, expected.size());
    for (std::size_t i = 0; i < p.owned; i++) {
      ASSERT_EQ(expected[i], std::pair(p.cell[i], p.id[i])) << "round " << round << ", row " << i;
      ASSERT_EQ(p.mass[i], static_cast<double>(p.id[i]));
      ASSERT_EQ(p.velocity[i].z, 3 * p.mass[i]);
      ASSERT_EQ(p.material[i], p.id[i] % 999);
    }
    std::size_t total = 0;
    for (std::uint32_t c : b.cells.count) total += c;
    EXPECT_EQ(total, p.owned);
  }
}
// A particle created here in another rank's cell departs with the arrived rows; nothing else moves.
TEST(Sort, RowsThatArriveAndDepartAtOnceAreDropped) {
  Block b(6, 0.1);
  Continuum& p = b.particles;
  const std::size_t before = p.owned;
  p.resize(before + 1, 0);
  p.id[before] = 4711;
  computeCellKeys(b.grid, p);
  Migration m;
  m.arrivals = 1;
  m.departed = {static_cast<std::uint32_t>(before)};
  sortByCell(p, m, b.sort, b.cells);
  EXPECT_EQ(p.owned, before);
}

INSTANTIATE_TEST_SUITE_P(Moves, SortMoved, testing::Values(0.0, 1e-3, 0.02, 0.4, 3.0));

class Search : public testing::TestWithParam<const char*> {};

/// Checks the lists of every `stride`th row against all pairs.
void expectBruteForce(const Block& b, std::uint32_t stride) {
  const Continuum& p = b.particles;
  const double h = b.grid.support;
  for (std::uint32_t i = 0; i < p.owned; i += stride) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < p.owned; j++)
      // rows are in (cell, id) order
      if (j != i && length(p.position[i] - p.position[j]) < h) expected.push_back(j);
    std::vector<std::uint32_t> found = b.neighboursOf(i);
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
    std::erase_if(found, [&](std::uint32_t j) { return length(p.position[i] - p.position[j]) >= h; });
    ASSERT_EQ(found, expected) << "row " << i;
  }
}

TEST_P(Search, EqualsBruteForceInCellAndIdOrder) {
  const PairKernels* k = pairKernels(GetParam());
  if (k == nullptr) GTEST_SKIP() << "this processor has no " << GetParam();
  Block b(11, 0.45, 2.3);
  b.findNeighbours(*k);
  expectBruteForce(b, 13);
}

// Hundreds of rows per cell: many rounds of 32 per particle, more than the initial capacity.
TEST_P(Search, EqualsBruteForceInCrowdedCells) {
  const PairKernels* k = pairKernels(GetParam());
  if (k == nullptr) GTEST_SKIP() << "this processor has no " << GetParam();
  Block b(17, 0.45);
  for (std::size_t i = 0; i < b.particles.owned; i++)
    b.particles.position[i] = b.particles.position[i] * 0.25 + Vec3d{0.03, 0.05, 0.04};
  computeCellKeys(b.grid, b.particles);
  sortByCell(b.particles, {}, b.sort, b.cells);
  ASSERT_GT(*std::max_element(b.cells.count.begin(), b.cells.count.end()), 256u);
  b.findNeighbours(*k);
  EXPECT_GT(b.search.rounds.size(), 64u);
  expectBruteForce(b, 29);
}
INSTANTIATE_TEST_SUITE_P(InstructionSets, Search, testing::Values("base", "avx2", "avx512"));

TEST(Search, HandlesOneParticleAndNone) {
  Block one(1, 0);
  one.findNeighbours(*pairKernels());
  EXPECT_EQ(one.lists.groups, 1u);
  EXPECT_EQ(one.neighboursOf(0).size(), 0u);
  Block none(0 + 1, 0);
  none.particles.resize(0, 0);
  none.cells = {};
  none.findNeighbours(*pairKernels());
  EXPECT_EQ(none.lists.groups, 0u);
}

TEST(Search, HandlesAllParticlesInOneCell) {
  Block b(6, 0.3);
  for (std::size_t i = 0; i < b.particles.owned; i++)
    b.particles.position[i] = b.particles.position[i] * 0.1 + Vec3d{0.02, 0.02, 0.02};
  Migration m;
  m.arrivals = 0;
  computeCellKeys(b.grid, b.particles);
  sortByCell(b.particles, m, b.sort, b.cells);
  b.findNeighbours(*pairKernels());
  EXPECT_EQ(b.neighboursOf(5).size(), b.particles.owned - 1);
}

}  // namespace thaw::test
