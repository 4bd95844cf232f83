// SPDX-License-Identifier: Apache-2.0
// Work data of the redistribution of particles: partition, particles that leave, order.
#pragma once
#include <cstdint>
#include <vector>

#include "core/ledger/leaver.hpp"
#include "core/neighbours/migration.hpp"
#include "core/neighbours/sort.hpp"

namespace thaw {

struct RedistributionWork {
  SortBuffers sort;
  std::size_t emitted = 0;             ///< number of new particles, which are the last owned rows until they
                                       ///< migrate
  std::vector<std::uint32_t> leaving;  ///< rows that leave the domain, ascending
  std::vector<std::uint32_t> vapour;   ///< leaving rows that evaporated
  Migration migration;                 ///< moves of this step
  bool moved = false;                  ///< rows have moved to other ranks; false: at most their order changed
  std::vector<Leaver> leavers;         ///< from all ranks; empty without surface tension
  bool mayLeave = true;                ///< a particle may be beyond an open side; false: the drift found no
                                       ///< such particle
  bool newPartition = true;            ///< cell owners may differ from the last evaluation
  bool looseMemory = false;  ///< the last evaluation had a new partition, and its temporary memory is free
};

}  // namespace thaw
