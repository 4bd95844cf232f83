// SPDX-License-Identifier: Apache-2.0
// Directory of the owners of solid particles, distributed over the ranks by a hash of the id.
#pragma once
#include <cstdint>
#include <vector>

#include "core/particles/id_table.hpp"

namespace thaw {

/// Returns the rank that stores the owner of this id.
inline int directoryRank(std::uint64_t id, int ranks) {
  return static_cast<int>((spreadBits(id) >> 32) % static_cast<std::uint64_t>(ranks));
}

/// This rank's part of the directory.
class SolidDirectory {
 public:
  static constexpr std::uint64_t noOwner = ~0ull;
  /// Sets the owner of an id. owner: a rank, or noOwner (no longer solid), which only the present owner may
  /// set. Otherwise a particle that melts on one rank and freezes on another could be removed by reordered
  /// messages.
  void set(std::uint64_t id, std::uint64_t owner, int sender) {
    if (owner != noOwner) table_.insert(id, static_cast<std::uint32_t>(owner));
    else if (find(id) == static_cast<std::uint64_t>(sender)) table_.erase(id);
  }
  std::uint64_t find(std::uint64_t id) const {
    const std::uint32_t owner = table_.find(id);
    return owner == IdTable::none ? noOwner : owner;
  }
  std::size_t size() const { return table_.size(); }

 private:
  IdTable table_;
};

}  // namespace thaw
