// SPDX-License-Identifier: Apache-2.0
// Communication statistics of a rank: messages by purpose, and waiting time. All halos share one
// communicator, which counts messages at the cost of a few additions each.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace thaw {

/// Purposes of messages. Ghosts: cells with their particles, at each search. Refresh: columns of the same
/// ghosts. Migration: particles to the rank that owns their cell. Bonds: columns along bonds. BondEdits:
/// changes of bonds. Rows: values back to particles. Balance: cells to the half that will own them.
/// Reduction: sums and maxima over all ranks, no messages.
enum class MessagesFor : std::uint8_t {
  Ghosts,
  Refresh,
  Migration,
  Bonds,
  BondEdits,
  Rows,
  Balance,
  Reduction
};
inline constexpr std::size_t purposes = 8;

inline const char* purposeName(MessagesFor purpose) {
  constexpr const char* names[purposes] = {"ghosts",     "refresh", "migration", "bonds",
                                           "bond_edits", "rows",    "balance",   "reduction"};
  return names[static_cast<std::size_t>(purpose)];
}

struct CommunicationStatistics {
  struct Sum {
    std::int64_t messages = 0, bytes = 0;  ///< sent to other ranks
    double waited = 0;                     ///< s
  };
  std::array<Sum, purposes> of{};
  std::int64_t collectives = 0;  ///< collective calls: reductions, barriers, splits

  Sum& operator[](MessagesFor p) { return of[static_cast<std::size_t>(p)]; }
  const Sum& operator[](MessagesFor p) const { return of[static_cast<std::size_t>(p)]; }
  void sent(MessagesFor p, std::size_t bytes) {
    (*this)[p].messages++;
    (*this)[p].bytes += static_cast<std::int64_t>(bytes);
  }
  Sum total() const {
    Sum all;
    for (const Sum& s : of) all.messages += s.messages, all.bytes += s.bytes, all.waited += s.waited;
    return all;
  }
};

}  // namespace thaw
