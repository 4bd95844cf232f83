// SPDX-License-Identifier: Apache-2.0
// Data that the elastic step caches for bonds, computed for eight solids at once. The bits are those of one
// solid at a time, with every instruction set.
#include <gtest/gtest.h>

#include <cstring>

#include "core/solid/elasticity/reference_kernels.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "tests/support/solid_body.hpp"

namespace thaw::test {
namespace {

struct Kept {
  Sym3d inverse;
  double perTrace, perWeight, strainBound;
  unsigned rank, singular;
};
Kept keptOf(const SolidBody& b, std::size_t s) {
  return {b.solids.momentInverse[s], b.work.perTrace[s], b.work.perWeight[s],
          b.work.strainBound[s],     b.work.rank[s],     b.work.singularLanes[s / lanes] >> s % lanes & 1u};
}

/// Number of solids whose data differ between these kernels and one solid at a time.
std::size_t differing(SolidBody& b, const char* kernels) {
  for (std::size_t s = 0; s < b.solids.owned; s++) refreshSolid(b.work, b.solids, b.bonds, s);
  std::vector<Kept> alone;
  for (std::size_t s = 0; s < b.solids.owned; s++) alone.push_back(keptOf(b, s));
  b.work.referenceKernels = referenceKernels(kernels);
  std::size_t different = 0;
  for (std::size_t g = 0; g < b.solids.owned / lanes; g++) {
    for (std::size_t s = g * lanes; s < (g + 1) * lanes; s++) {
      b.solids.momentInverse[s] = {1, 2, 3, 4, 5, 6};
      b.work.perTrace[s] = b.work.perWeight[s] = b.work.strainBound[s] = -1;
      b.solids.changed[s] = 1;
    }
    refreshGroup(b.work, b.solids, b.bonds, g);
    for (std::size_t s = g * lanes; s < (g + 1) * lanes; s++) {
      const Kept together = keptOf(b, s);
      different += std::memcmp(&together, &alone[s], sizeof(Kept)) != 0 || b.solids.changed[s];
    }
  }
  return different;
}

TEST(GroupMoments, EqualThoseOfSingleSolids) {
  std::vector<Vec3d> fragments = lattice({4, 4, 3}, 0.1, 0.2);
  // a plane: rank 2
  for (std::size_t k = 0; k < 12; k++)
    fragments.push_back({1.0 + 0.1 * double(k % 4), 0.1 * double(k / 4), 0});
  // nearly a line
  for (std::size_t k = 0; k < 8; k++) fragments.push_back({2.0 + 0.1 * double(k), 1e-3 * double(k % 2), 0});
  // alone: no bonds
  for (std::size_t k = 0; k < 12; k++) fragments.push_back({3.0 + double(k), 3, 0});
  BodyOptions periodic;
  periodic.period = {0.6, 0, 0.6};
  for (const char* kernels : {"base", "avx2", "avx512"}) {
    if (!referenceKernels(kernels)) continue;
    const auto open = makeBody(fragments, {elasticMaterial()}),
               wrapped = makeBody(lattice({6, 6, 6}, 0.1, 0.2), {elasticMaterial()}, periodic);
    ASSERT_FALSE(open->bonds.vectors);
    EXPECT_EQ(differing(*open, kernels), 0u) << kernels;
    EXPECT_EQ(differing(*wrapped, kernels), 0u) << kernels;
  }
}

}  // namespace
}  // namespace thaw::test
