// Who owns which solid particle: a table spread over the ranks by a hash of the id.
#pragma once
#include <cstdint>
#include <vector>

#include "core/solid/id_table.hpp"

namespace thaw {

/// The rank that knows who owns this id.
inline int directoryRank(std::uint64_t id, int ranks) {
  return static_cast<int>((spreadBits(id) >> 32) % static_cast<std::uint64_t>(ranks));
}

/// This rank's part of the directory.
class SolidDirectory {
 public:
  static constexpr std::uint64_t nobody = ~0ull;
  /// owner: a rank, or nobody: not solid any more, which only the owner may say. A particle that melts here
  /// and freezes there at once must not be struck out by news that come in another order.
  void set(std::uint64_t id, std::uint64_t owner, int teller) {
    if (owner != nobody) table_.insert(id, static_cast<std::uint32_t>(owner));
    else if (find(id) == static_cast<std::uint64_t>(teller)) table_.erase(id);
  }
  std::uint64_t find(std::uint64_t id) const {
    const std::uint32_t owner = table_.find(id);
    return owner == IdTable::none ? nobody : owner;
  }
  std::size_t size() const { return table_.size(); }

 private:
  IdTable table_;
};

}  // namespace thaw
