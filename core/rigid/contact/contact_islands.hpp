// SPDX-License-Identifier: Apache-2.0
// Contact islands: sets of movable rows connected by contacts. One rank solves an island.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/contact/rigid_contact.hpp"

namespace thaw {

/// Contact island. The order of rows and contacts does not depend on the ranks.
struct ContactIsland {
  std::vector<std::uint64_t> ids;      ///< ids of the rows, ascending
  std::vector<PieceMotion> pieces;     ///< motions of the rows; prescribed rows may be in several islands
  std::vector<RigidContact> contacts;  ///< a and b are rows of the island
  std::vector<PieceChange> changes;    ///< changes of the rows, set by the solver
};

/// Islands that this rank solves, and the sources of their parts.
struct GatheredIslands {
  std::vector<ContactIsland> islands;

  /// Rows and contacts of islands that this rank sent to one rank, in the order of the message.
  struct Sent {
    std::vector<std::uint32_t> rows, contacts;
  };
  std::vector<Sent> sent;  ///< one for each rank

  /// Part of an island received from a rank: indices of rows and contacts in the island, in the order of the
  /// message.
  struct Part {
    int rank = 0;
    std::uint32_t island = 0;
    std::vector<std::uint32_t> rows, contacts;
  };
  std::vector<Part> parts;  ///< parts from one rank are in the order of its message
};

/// Gathers each island on one rank: the rank that has all its rows, or else a home rank. Contacts between
/// prescribed rows belong to no island. Requires: a row has the same bits on all ranks that hold it.
/// Collective.
GatheredIslands gatherIslands(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                              PieceExchange& exchange, Reducer& all);

/// Sets the results of the islands on all ranks: contact impulses, and velocity, spin and changes of movable
/// rows. Collective.
void returnIslands(const GatheredIslands& gathered, std::span<PieceMotion> pieces,
                   std::span<RigidContact> contacts, std::span<PieceChange> changes, Reducer& all);

}  // namespace thaw
