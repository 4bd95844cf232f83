// Which slots this rank sends to whom along the bonds, and which remote rows it fills from whom; both ends
// keep the same order, by id.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/solid/bond_graph.hpp"
#include "parallel/communicator.hpp"
#include "parallel/word_messages.hpp"

namespace thaw {

class BondLinks {
 public:
  /// For every owned slot that another rank copies and whose owner in the graph is not this rank any more:
  /// (id, new owner), to the copies.
  void announceDepartures(const BondGraph& graph, int rank, WordMessages& out) const;
  /// (id, nobody) to the ranks that copy these slots.
  void announceRemovals(const BondGraph& graph, std::span<const std::uint32_t> slots,
                        WordMessages& out) const;

  /// After an edit of the graph: follows the renumbering, gives up what is not named any more and asks for
  /// what is new or has moved. Collective.
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
