// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/coincident.hpp"

#include <cstring>

#include "core/math/hash_random.hpp"

namespace thaw {

void separateCoincident(World& w, const PairRecords& records, std::int64_t before) {
  if (w.counters.coincidentPairs == before) return;
  Continuum& p = w.particles;
  const NeighbourLists& lists = w.neighbours;
  const std::uint32_t* positionVolume = reinterpret_cast<const std::uint32_t*>(records.fixed.data());
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy) continue;
      bool together = false;
      for (std::uint32_t k = 0; k < lists.count[g] && !together; k++) {
        const std::uint32_t j = lists.row(g, k, l);
        together = j != lists.dummy &&
                   std::memcmp(positionVolume + 4ull * i, positionVolume + 4ull * j, 12) == 0;
      }
      if (!together) continue;
      Vec3d d;
      for (int a = 0; a < 3; a++)
        d[a] = randomUniform(w.scene.seed, Purpose::Separate, p.id[i], static_cast<std::uint64_t>(a)) - 0.5;
      p.position[i] += d * (1e-5 * w.scene.spacing);
      if (p.restTime.active) p.restTime[i] = 0;
    }
}

}  // namespace thaw
