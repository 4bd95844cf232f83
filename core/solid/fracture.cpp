// SPDX-License-Identifier: Apache-2.0
#include "core/solid/fracture.hpp"

#include <algorithm>
#include <vector>

#include "core/solid/elasticity/solid_state.hpp"

namespace thaw {

namespace {

bool beyondLimit(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t solidIndex,
                 int k) {
  const std::uint32_t other = bonds.neighbour[bonds.at(solidIndex, k)];
  const double limit = std::min(work.materials[solids.material[solidIndex]].breakStretch,
                                work.materials[solids.material[other]].breakStretch);
  if (!(limit < never)) return false;
  const BondVectors v = bondVectors(work, solids, bonds, solidIndex, k);
  // Ends within the contact distance would repel each other and gain energy. Their bond therefore breaks only
  // after they separate.
  const double length2 = dot(v.current, v.current);
  return length2 > work.touch * work.touch &&
         length2 > limit * limit * std::max(dot(v.reference, v.reference), dot(v.reverse, v.reverse));
}

}  // namespace

std::int64_t breakBonds(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                        ExactSum& phaseJump) {
  std::int64_t count = 0;
  if (!(work.minBreakStretch < never)) return 0;
  std::vector<std::uint32_t> broken;
  std::vector<int> lost;
  for (std::size_t g = 0; g < work.stretched.size(); g++) {
    if (work.stretched[g] == 0) continue;
    bool any = false;
    for (std::size_t s = g * lanes, end = std::min(s + lanes, solids.owned); s < end; s++) {
      lost.clear();
      for (int k = 0; k < work.bondCount[g]; k++)
        if (bonds.hasBond(s, k) && beyondLimit(work, solids, bonds, s, k)) lost.push_back(k);
      if (lost.empty()) continue;
      solids.markExposed(s);
      const DriftEnergy before = driftEnergy(work, solids, bonds, s, step.dt);
      for (const int k : lost) {
        count += solids.id[s] < solids.id[bonds.neighbour[bonds.at(s, k)]];
        bonds.cut(s, k);
      }
      refreshSolid(work, solids, bonds, s);
      // If stretched bonds break and compressed ones stay, the remaining strain can be larger. The volume is
      // then reduced, so that a break never adds energy. Otherwise each crack would trigger the next until
      // the solid is dust.
      const double after = solidEnergy(work, solids, bonds, s);
      if (after > before.now) solids.volume[s] *= before.now / after;
      recordJump(before, driftEnergy(work, solids, bonds, s, step.dt), phaseJump);
      any = true;
    }
    if (any) broken.push_back(static_cast<std::uint32_t>(g));
  }
  if (!broken.empty()) repeatDeformation(work, solids, bonds, step, broken);
  return count;
}

}  // namespace thaw
