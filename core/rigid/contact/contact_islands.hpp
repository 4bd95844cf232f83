// SPDX-License-Identifier: Apache-2.0
// Islands of contacts: sets of movable rows that contacts connect. One rank solves an island.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/contact/rigid_contact.hpp"

namespace thaw {

/// Rows and contacts are in an order that does not depend on ranks.
struct ContactIsland {
  std::vector<std::uint64_t> ids;      ///< ids of the rows, ascending
  std::vector<PieceMotion> pieces;     ///< rows; prescribed ones may be in several islands
  std::vector<RigidContact> contacts;  ///< a and b are rows of the island
  std::vector<PieceChange> changes;    ///< changes of the rows, set by the solver
};

/// The islands that this rank solves, and where their parts come from.
struct GatheredIslands {
  std::vector<ContactIsland> islands;

  /// Rows and contacts of islands that this rank sent to a rank, in the order of the message.
  struct Sent {
    std::vector<std::uint32_t> rows, contacts;
  };
  std::vector<Sent> sent;  ///< one for each rank

  /// A part of an island that a rank sent: its rows and contacts in the island, in the order of the message.
  struct Part {
    int rank = 0;
    std::uint32_t island = 0;
    std::vector<std::uint32_t> rows, contacts;
  };
  std::vector<Part> parts;  ///< the parts of a rank are in the order of its message
};

/// Brings each island to one rank: the one that has all its rows, or a home rank. Contacts between
/// prescribed rows belong to no island. Requires: all ranks that hold a row give the same bits. Collective.
GatheredIslands gatherIslands(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                              PieceExchange& exchange, Reducer& all);

/// Sets the results of the islands on all ranks: impulses of contacts, velocity and spin of movable rows, and
/// their changes. Collective.
void returnIslands(const GatheredIslands& gathered, std::span<PieceMotion> pieces,
                   std::span<RigidContact> contacts, std::span<PieceChange> changes, Reducer& all);

}  // namespace thaw
