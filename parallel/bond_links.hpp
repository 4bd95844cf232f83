// SPDX-License-Identifier: Apache-2.0
// Exchange lists along bonds: solids that this rank sends, and remote rows that it receives, by partner rank.
// Both ends have the same order, by id.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/solid/bonds/bond_graph.hpp"
#include "parallel/communicator.hpp"
#include "parallel/word_messages.hpp"

namespace thaw {

class BondLinks {
 public:
  /// Announces (id, new owner) to the holders of copies, for every copied solid whose owner in the graph is
  /// another rank.
  void announceDepartures(const BondGraph& graph, int rank, WordMessages& out) const;
  /// Announces (id, noOwner) to the ranks with copies of these solids.
  void announceRemovals(const BondGraph& graph, std::span<const std::uint32_t> solidIndices,
                        WordMessages& out) const;

  /// Updates the lists after an edit of the graph: applies the renumbering, releases unused rows and
  /// subscribes to new or moved ones. Collective.
  void renew(const Communicator& comm, const BondGraph& graph);

  void begin(const Communicator& comm, std::span<AnyColumn* const> columns);
  void finish(const Communicator& comm);

 private:
  struct Link {
    std::uint64_t id;
    std::uint32_t row;
  };
  struct Partner {
    int rank = 0;
    std::vector<Link> sends, receives;  // ascending by id
    std::vector<std::byte> out, in;
    std::vector<MPI_Request> sending, receiving;
  };
  Partner& partner(int rank);
  static bool holds(const std::vector<Link>& links, std::uint64_t id);
  static void add(std::vector<Link>& links, std::vector<Link>& more);

  std::vector<Partner> partners_;  // ascending by rank
  std::vector<AnyColumn*> columns_;
  ExchangeMark mark_;
};

}  // namespace thaw
