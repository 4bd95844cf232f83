// SPDX-License-Identifier: Apache-2.0
// K05 updates the neighbourhoods of surfels by neighbours of neighbours; thaw searches bins with a margin.
// Compares the neighbours found and the time of both.
#include <gtest/gtest.h>

#include <ctime>

#include "core/surface/search/row_lists.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

std::vector<std::vector<std::uint32_t>> within(const Surfels& s, const RowLists& lists, double radius) {
  std::vector<std::vector<std::uint32_t>> found(s.owned);
  for (std::size_t i = 0; i < s.owned; i++) {
    for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++)
      if (length(s.position[lists.row[k]] - s.position[i]) < radius) found[i].push_back(lists.row[k]);
    std::sort(found[i].begin(), found[i].end());
  }
  return found;
}

/// The current neighbours among the earlier neighbours and their neighbours.
std::vector<std::vector<std::uint32_t>> byNeighbours(const Surfels& s,
                                                     const std::vector<std::vector<std::uint32_t>>& then,
                                                     double radius) {
  std::vector<std::vector<std::uint32_t>> now(s.owned);
  std::vector<std::uint32_t> seen(s.owned, 0xffffffffu);
  for (std::uint32_t i = 0; i < s.owned; i++) {
    const auto look = [&](std::uint32_t j) {
      if (j == i || seen[j] == i) return;
      seen[j] = i;
      const Vec3d d = s.position[j] - s.position[i];
      if (dot(d, d) < radius * radius) now[i].push_back(j);
    };
    for (const std::uint32_t j : then[i]) {
      look(j);
      for (const std::uint32_t k : then[j]) look(k);
    }
    std::sort(now[i].begin(), now[i].end());
  }
  return now;
}

std::size_t missing(const std::vector<std::vector<std::uint32_t>>& all,
                    const std::vector<std::vector<std::uint32_t>>& some) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < all.size(); i++)
    for (const std::uint32_t j : all[i]) n += !std::binary_search(some[i].begin(), some[i].end(), j);
  return n;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(NeighbourUpdate, ListsWithAMarginFindAllNeighbours) {
  const double d = 0.05, radius = 3 * d, margin = 2 * d;
  SurfelRig rig(surfelScene(d));
  // two balls approach by 0.2 spacings per iteration, with moving surfels
  const std::size_t each = 6000;
  for (const double side : {-1.0, 1.0})
    for (const SurfacePoint& p : spherePoints(each, 1))
      rig.add(p.position + Vec3d{side * 1.15, 0, 0}, p.normal);
  Surfels& s = rig.surfels();
  const std::vector<std::uint8_t> all(s.owned, 1);
  RowLists lists, exact;
  const auto search = [&](double reach, RowLists& to) {
    s.resize(s.owned, 0);
    Bins& bins = rig.tools.relax.surfelBins;
    CellTable one;
    one.key = {0};
    one.first = {0};
    one.count = {static_cast<std::uint32_t>(s.owned)};
    fillBins(rig.world.surface.grid, one, s.position.data(), 0.5 * reach, bins);
    findRows(bins, s.position.data(), s.owned, all, reach, to);
  };
  search(radius, exact);
  auto chained = within(s, exact, radius);
  double furthest = 0, listTime = 0, chainTime = 0;
  std::size_t searches = 0, missedByLists = 0, missedByChain = 0, pairs = 0;
  std::vector<Vec3d> foundAt;
  for (int step = 0; step < 30; step++) {
    if (foundAt.empty() || furthest > 0.5 * margin) {
      const double t = seconds();
      search(radius + margin, lists);
      listTime += seconds() - t;
      searches++;
      foundAt.assign(s.position.data(), s.position.data() + s.owned);
    }
    furthest = 0;
    for (std::size_t i = 0; i < s.owned; i++) {
      const auto u = [&](std::uint64_t k) {
        return randomUniform(9 + k, Purpose::Test, s.id[i], static_cast<std::uint64_t>(step)) - 0.5;
      };
      s.position[i] += Vec3d{s.position[i].x < 0 ? 0.1 * d : -0.1 * d, 0, 0} +
                       (0.1 * d) * Vec3d{u(0), u(1), u(2)};
      furthest = std::max(furthest, length(s.position[i] - foundAt[i]) + 0.2 * d);
    }
    search(radius, exact);
    const auto truth = within(s, exact, radius);
    const double t = seconds();
    chained = byNeighbours(s, chained, radius);
    chainTime += seconds() - t;
    missedByLists += missing(truth, within(s, lists, radius));
    missedByChain += missing(truth, chained);
    for (const auto& n : truth) pairs += n.size();
  }
  std::printf(
      "30 iterations of %zu surfels, %.1f neighbours: lists with a margin miss %zu of %zu, %zu searches, "
      "%.2f us a surfel and iteration; neighbours of neighbours miss %zu (%.3f %%), %.2f us\n",
      s.owned, static_cast<double>(pairs) / 30 / static_cast<double>(s.owned), missedByLists, pairs, searches,
      1e6 * listTime / 30 / static_cast<double>(s.owned), missedByChain,
      100 * static_cast<double>(missedByChain) / static_cast<double>(pairs),
      1e6 * chainTime / 30 / static_cast<double>(s.owned));
  EXPECT_EQ(missedByLists, 0u);
  EXPECT_GT(missedByChain, 0u);  // surfels of an approaching sheet have no common neighbour before
  EXPECT_LT(listTime, chainTime);
}

}  // namespace
}  // namespace thaw
