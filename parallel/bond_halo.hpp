// SPDX-License-Identifier: Apache-2.0
// BondHalo over MPI. A rank that sends a solid particle away notifies the ranks that hold copies. The cost of
// tracking owners is thus proportional to the number of migrations. A directory distributed over the ranks
// stores the owner of every solid particle, for ranks without a copy. Also works on one rank, without
// messages.
#pragma once
#include <cstdint>
#include <vector>

#include "core/solid/bonds/bond_graph.hpp"
#include "parallel/bond_links.hpp"
#include "parallel/cell_halo.hpp"
#include "parallel/solid_directory.hpp"

namespace thaw {

class MpiBondHalo : public BondHalo {
 public:
  explicit MpiBondHalo(const Communicator& comm) : comm_(comm), graph_(comm.rank()) {}

  /// Throws std::logic_error if the solids of the last migration were not yet created by a bond update.
  void migrate(const BondedRows& particles, Solids& solids, Bonds& bonds,
               const Migration& migration) override;
  bool rebuildBonds(const BondedRows& particles, Solids& solids, Bonds& bonds,
                    const BondUpdate& work) override;
  void begin(Solids& solids, std::span<AnyColumn* const> columns) override;
  void finish(Solids& solids) override;

  /// Adopts records (SolidRecords::bytes) of owned particles without a row in Solids, read from a checkpoint
  /// on any rank. If the particle migrates first, its record follows. The next bond update creates the
  /// solids; records of other particles are discarded.
  void adopt(std::vector<std::byte> records);
  const BondGraph& graph() const { return graph_; }

 private:
  enum Kind { RecordKind = 40, UpdateKind = 41, QueryKind = 42, AnswerKind = 43 };  // kinds of messages
  /// Solid particles about to enter the table.
  struct PendingRecords {
    std::vector<std::byte> records;
    std::vector<std::int32_t> owners;  // owner of the other end of each bond, record by record; empty if
                                       // adopted
    bool adopted = false;              // from a checkpoint: not yet in the directory
  };
  struct Found {  // a record in pendingRecords_
    std::uint64_t id;
    std::size_t waiting, at, end, owner;
  };
  struct Departure {
    std::uint32_t solidIndex;
    int to;
  };

  int anyRank(int bits) const;
  std::vector<Message> exchange(const std::vector<Message>& out, int kind);
  void listPendingRecords(const Solids& solids);
  const Found* findPendingRecord(std::uint64_t id) const;
  void sendDepartures();
  void sendRecords(const BondedRows& particles, const Solids& solids, const Bonds& bonds,
                   const Migration& migration);
  void applyUpdates(const std::vector<Message>& in, bool edit);
  void leaveSolids(const Solids& solids, const Bonds& bonds);
  void makeSolids(const SolidTables& tables, const BondUpdate& work);
  void matchRecords(const BondedRows& particles);
  void sendChanges(const BondedRows& particles);
  std::vector<std::uint64_t> unknownIds(const Solids& solids, const BondUpdate& work, bool all);
  void queryOwners(const std::vector<std::uint64_t>& ids);
  void checkMoves(const Solids& solids, const BondUpdate& work);
  int ownerOf(std::uint64_t id) const;

  const Communicator& comm_;
  BondGraph graph_;
  BondLinks links_;
  SolidDirectory directory_;
  std::vector<PendingRecords> pendingRecords_;
  std::vector<Found> found_;                   // ascending by id
  std::vector<Departure> departures_;          // until the next bond update
  std::vector<std::uint32_t> withoutIndex_;    // rows of particles that get a row in Solids
  std::vector<std::uint32_t> removed_;         // solids
  std::vector<std::uint64_t> meltedArrivals_;  // ids of particles that arrived but are no longer solid
  std::vector<std::uint32_t> movedRows_;       // remote rows whose particle has migrated since the last bond
                                               // update
  std::vector<NewSolid> fresh_;
  std::vector<const Found*> recordOf_;  // record of each fresh solid; nullptr: the particle just became solid
  std::vector<std::uint64_t> queriedIds_;  // ascending
  std::vector<std::uint64_t> queriedOwners_;
  bool moved_ = false;         // solid particles migrated on some rank since the last bond update
  bool solidArrived_ = false;  // on this rank
};

}  // namespace thaw
