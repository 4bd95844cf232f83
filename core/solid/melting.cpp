// SPDX-License-Identifier: Apache-2.0
#include "core/solid/melting.hpp"

#include "core/solid/elasticity/slot_state.hpp"

namespace thaw {

namespace {

bool dropBonds(Solids& solids, Bonds& bonds, std::size_t slot, int most) {
  bool any = false;
  for (int k = 0; k < most; k++) {
    if (!bonds.hasBond(slot, k) ||
        !(solids.melted[slot] || solids.melted[bonds.neighbour[bonds.at(slot, k)]]))
      continue;
    bonds.cut(slot, k);
    any = true;
  }
  if (any) solids.markExposed(slot);
  return any;
}

}  // namespace

void markMelted(const Continuum& p, Solids& solids) {
  for (std::size_t s = 0; s < solids.owned; s++) solids.melted[s] = p.phase[solids.particle[s]] == Liquid;
}

std::int64_t dropMeltedBonds(ElasticWork& work, const Continuum& p, Solids& solids, Bonds& bonds,
                             ExactSum& phaseJump) {
  std::int64_t count = 0;
  for (std::size_t s = 0; s < solids.owned; s++) {
    if (!dropBonds(solids, bonds, s, work.bondCount[s / lanes])) continue;
    refreshSlot(work, solids, bonds, s);
    if (solids.liquid.active) solids.liquid[s] = p.liquid[solids.particle[s]];
    if (solids.lastGradient.active) solids.lastGradient[s] = slotGradient(work, solids, bonds, s);
    const double after = solids.melted[s] ? 0 : slotEnergy(work, solids, bonds, s);
    phaseJump.add(solids.energy[s] - after);
    solids.energy[s] = after;
    count++;
  }
  return count;
}

}  // namespace thaw
