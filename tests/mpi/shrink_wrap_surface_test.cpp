// SPDX-License-Identifier: Apache-2.0
// The distributed surface of a body that sheets wrap: the part on each rank against the complete surface, and
// the forces returned to it.
#include "core/sheet/shrink_wrap/shrink_wrap_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/math/hash_random.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "parallel/communicator.hpp"

namespace thaw {
namespace {

constexpr int size = 45;  // cells of the domain along an axis: several blocks
const double edge = 0.1;

/// A ball with a hole and a few detached cells.
bool taken(const Vec3i& c) {
  const Vec3d x{c.x - 22.0, c.y - 21.5, c.z - 23.0};
  if (c.x < 0 || c.y < 0 || c.z < 0 || c.x >= size || c.y >= size || c.z >= size) return false;
  return (length(x) < 17 && length(x - Vec3d{6, 2, 0}) > 5) ||
         randomUniform(3, Purpose::Test, cellKey(c)) < 0.0005;
}

Vec3d middleOf(const Vec3i& c) {
  Vec3d x;
  for (int a = 0; a < 3; a++)
    x[a] = edge * (c[a] + randomUniform(5, Purpose::Test, cellKey(c), static_cast<std::uint64_t>(a)));
  return x;
}

TEST(WrapParts, RanksHoldTheirPartsAndReturnTheForces) {
  const Communicator comm(MPI_COMM_WORLD);
  MpiReducer all(comm);
  Domain domain;
  domain.min = {};
  domain.max = {edge * size, edge * size, edge * size};
  CellGrid grid = makeGrid(domain, edge);
  grid.origin = {};
  std::vector<ShrinkWrapCell> mine, surface;
  for (int z = 0; z < size; z++)
    for (int y = 0; y < size; y++)
      for (int x = 0; x < size; x++) {
        const Vec3i c{x, y, z};
        if (!taken(c)) continue;
        const ShrinkWrapCell p{cellKey(c), 1 + 0.1 * x, middleOf(c)};
        // some ranks have no part
        if (static_cast<int>(mixBits(p.key) % 5) * all.size() / 5 == all.rank()) mine.push_back(p);
        if (!(taken({x + 1, y, z}) && taken({x - 1, y, z}) && taken({x, y + 1, z}) && taken({x, y - 1, z}) &&
              taken({x, y, z + 1}) && taken({x, y, z - 1})))
          surface.push_back(p);
      }
  std::vector<Vec3d> places;  // none on the last rank; a few in one corner, far, near and inside
  for (std::uint64_t k = 0; k < 40 && all.rank() + 1 < std::max(2, all.size()); k++)
    places.push_back(edge * size *
                     Vec3d{randomUniform(7, Purpose::Test, k, 0), 0.3 * randomUniform(7, Purpose::Test, k, 1),
                           randomUniform(7, Purpose::Test, k, 2)});
  const ShrinkWrapSurface found = findShrinkWrapSurface(all, grid, mine, places, 2 * edge);
  EXPECT_TRUE(found.any);
  ASSERT_TRUE(std::is_sorted(found.near.begin(), found.near.end(),
                             [](const ShrinkWrapCell& a, const ShrinkWrapCell& b) { return a.key < b.key; }));
  std::set<std::uint64_t> has, of;
  for (const ShrinkWrapCell& p : surface) of.insert(p.key);
  for (const ShrinkWrapCell& p : found.near) {
    EXPECT_TRUE(of.contains(p.key));
    EXPECT_EQ(p.middle, middleOf(cellOfKey(p.key)));
    has.insert(p.key);
  }
  EXPECT_EQ(has.size(), found.near.size());
  for (const Vec3d& x : places) {
    double nearest = 1e300;
    for (const ShrinkWrapCell& p : surface) nearest = std::min(nearest, length(p.middle - x));
    for (const ShrinkWrapCell& p : surface)
      ASSERT_TRUE(length(p.middle - x) > nearest + 2 * edge || has.contains(p.key));
  }
  // each rank draws its parts by one unit along x and by its rank along y
  std::vector<std::int64_t> units;
  for (std::size_t k = 0; k < found.near.size(); k++) units.insert(units.end(), {1, all.rank(), -3});
  std::int64_t sums[3] = {0, 0, static_cast<std::int64_t>(found.near.size())};
  std::uint64_t last = 0;
  for (const ShrinkWrapForce& p : reduceShrinkWrapForces(all, found, units)) {
    EXPECT_GT(p.key, last);
    last = p.key;
    EXPECT_TRUE(
        std::any_of(mine.begin(), mine.end(), [&](const ShrinkWrapCell& m) { return m.key == p.key; }));
    EXPECT_EQ(p.units.z, -3 * p.units.x);
    sums[0] += p.units.x;
  }
  all.sum(sums);
  EXPECT_EQ(sums[0], sums[2]);
  EXPECT_FALSE(findShrinkWrapSurface(all, grid, {}, places, edge).any);
}

}  // namespace
}  // namespace thaw
