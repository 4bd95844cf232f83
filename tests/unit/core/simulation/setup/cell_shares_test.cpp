// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/cell_fractions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/geometry/shapes/primitives.hpp"

namespace thaw {
namespace {

std::vector<std::int64_t> pointsOf(const SignedDistance& shape, const SampleLattice& l) {
  std::vector<std::int64_t> points;
  KnownSides known;
  for (std::int64_t row = 0; row < l.rows(); row++)
    for (const std::int64_t i : insideOfRow(shape, l, row, known)) points.push_back(i + l.count[0] * row);
  return points;
}

TEST(CellFractions, WholeCellsAreFull) {
  const BoxDistance box({0.6, 0.4, 0.3});
  const SampleLattice l = sampleLattice(box, 0.1);
  const std::vector<std::int64_t> points = pointsOf(box, l);
  ASSERT_EQ(points.size(), 72u);
  for (const std::int32_t s : cellFractions(box, l, points)) EXPECT_EQ(s, wholeCell);
}

TEST(CellFractions, HoldTheVolumeOfABoxWithPartialCells) {  // 1.35 cells: two points, the cells are two
                                                            // thirds full
  const BoxDistance box({0.135, 0.4, 0.4});
  const SampleLattice l = sampleLattice(box, 0.1);
  const std::vector<std::int64_t> points = pointsOf(box, l);
  ASSERT_EQ(points.size(), 32u);
  // three of four layers of samples
  for (const std::int32_t s : cellFractions(box, l, points)) EXPECT_EQ(s, 48);
}

TEST(CellFractions, StretchedCellsAreFull) {
  const BoxDistance box({0.535, 0.448, 0.4});
  const SampleLattice l = sampleLattice(box, 0.1);
  for (const std::int32_t s : cellFractions(box, l, pointsOf(box, l))) EXPECT_EQ(s, wholeCell);
}

TEST(CellFractions, HoldTheVolumeOfABallOnAnyNumberOfRanks) {
  const SphereDistance ball(0.885);
  const SampleLattice l = sampleLattice(ball, 0.1);
  const std::vector<std::int64_t> points = pointsOf(ball, l);
  const std::vector<std::int32_t> shares = cellFractions(ball, l, points);
  const double volume = 4.0 / 3 * std::numbers::pi * 0.885 * 0.885 * 0.885, cells = volume / l.mass(0, 1);
  EXPECT_NEAR(static_cast<double>(std::accumulate(shares.begin(), shares.end(), std::int64_t{0})) / wholeCell,
              cells, 0.002 * cells);
  // the share of a point is its nearest region, by a finer lattice of samples
  std::int32_t least = wholeCell, most = wholeCell;
  for (std::size_t k = 0; k < points.size(); k++) {
    least = std::min(least, shares[k]), most = std::max(most, shares[k]);
    const Vec3d x = l.at(points[k] % l.count[0], points[k] / l.count[0] % l.count[1],
                         points[k] / l.count[0] / l.count[1]);
    if (length(x) < 0.885 - 0.1 * 1.74) { EXPECT_EQ(shares[k], wholeCell); }
  }
  EXPECT_LT(least, 48);
  EXPECT_GT(most, 70);
  for (int rank = 0; rank < 3; rank++) {
    std::vector<std::int64_t> mine;
    std::vector<std::int32_t> wanted;
    const SampleRange range = sampleRange(l, rank, 3);
    for (std::size_t k = 0; k < points.size(); k++)
      if (const std::int64_t row = points[k] / l.count[0]; row >= range.begin && row < range.end)
        mine.push_back(points[k]), wanted.push_back(shares[k]);
    EXPECT_EQ(cellFractions(ball, l, mine), wanted);
  }
}

}  // namespace
}  // namespace thaw
