// SPDX-License-Identifier: Apache-2.0
// Bonds whose other end took a new reference.
#include <algorithm>

#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/elasticity/solid_state.hpp"

namespace thaw {

void copyReferences(ElasticWork& work, const Solids& solids, Bonds& bonds,
                    std::span<const std::uint32_t> groups, SolidRows flagged) {
  for (const std::uint32_t g : groups)
    for (std::size_t s = g * static_cast<std::size_t>(lanes), end = std::min(s + lanes, solids.owned);
         s < end; s++)
      for (int k = 0; k < work.bondCount[g]; k++) {
        const std::size_t b = bonds.at(s, k);
        const std::size_t other = bonds.neighbour[b];
        if (!bonds.hasBond(s, k) || other < flagged.begin || other >= flagged.end ||
            solids.rereferenced[other] == 0)
          continue;
        work.ownFrames[g] = 1;
        const Vec3d back = -bondVectors(work, solids, bonds, s, k).current;
        bonds.rx.set(b, back.x);
        bonds.ry.set(b, back.y);
        bonds.rz.set(b, back.z);
      }
}

void copyRemoteReferences(ElasticWork& work, const Solids& solids, Bonds& bonds) {
  if (!solids.rereferenced.active) return;
  bool any = false;
  for (std::size_t s = solids.owned; s < solids.size(); s++) any = any || solids.rereferenced[s] != 0;
  if (any) copyReferences(work, solids, bonds, work.boundary, {solids.owned, solids.size()});
}

}  // namespace thaw
