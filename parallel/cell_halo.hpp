// SPDX-License-Identifier: Apache-2.0
// CellHalo over MPI: migration, ghosts and periodic images, load balance.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/cell_copies.hpp"
#include "parallel/decomposition.hpp"
#include "parallel/sparse_exchange.hpp"

namespace thaw {

struct BalanceRule {
  double threshold = 1.05;  ///< ratio of largest to mean cost above which a new partition is computed
  double gain = 0.97;  ///< a new partition is used if its imbalance is below this fraction of the present one
  int pause = 3;       ///< calls skipped after a new partition was computed, unless it was forced
};

class MpiCellHalo : public CellHalo {
 public:
  /// Starts with boxes of equal size; rebalance as soon as particles exist. Collective. The communicator must
  /// outlive this object. Throws std::invalid_argument for a periodic axis of fewer than three cells, where
  /// images would overlap.
  MpiCellHalo(const Communicator& comm, const CellGrid& grid, const BalanceRule& rule = {});

  std::size_t bufferBytes() const override;
  Migration migrate(Table& particles, std::span<const std::uint64_t> keys) override;
  void beginGhosts(Table& particles, const CellTable& cells, std::span<AnyColumn* const> columns) override;
  void finishGhosts(Table& particles, CellTable& cells) override;
  void beginRefresh(Table& particles, std::span<AnyColumn* const> columns) override;
  void finishRefresh(Table& particles) override;
  bool rebalance(const CellTable& ownedCells, std::span<const double> cost, bool force) override;
  void follow(const CellHalo& leader) override;
  bool owns(std::uint64_t key) const override { return box_.contains(cellOfKey(key)); }
  bool inner(std::uint64_t key) const override { return innerCell(grid_, box_, cellOfKey(key)); }

  const std::vector<CellBox>& boxes() const { return partition_.boxes(); }
  /// Returns the ratio of largest to mean cost at the last call of rebalance, for the partition in use after
  /// it. It is 1 before the first call.
  double imbalance() const { return imbalance_; }

 private:
  /// Exchange data for one rank (for images: this rank itself).
  struct Neighbour {
    int rank = 0;
    CellCopies copies;                           // sent to it
    std::size_t ghostFirst = 0, ghostCount = 0;  // rows received from it
    std::vector<std::byte> out, in;              // never shrink
    std::size_t sendRoom = 0, receiveRoom = 0;   // equal on both ends
    std::vector<MPI_Request> receiving, sending;
  };
  void usePartition(Partition partition);
  void sendGhosts(Neighbour& n, const CellTable& cells);
  void receiveGhosts(Neighbour& n);
  std::size_t roomFor(std::size_t bytes) const;
  std::size_t appendCells(const Neighbour& n, CellTable& cells) const;

  const Communicator& comm_;
  CellGrid grid_;
  BalanceRule rule_;
  Partition partition_;
  CellBox box_;
  std::vector<Neighbour> neighbours_;
  std::vector<AnyColumn*> columns_;  // columns of the exchange in flight
  std::vector<std::uint32_t> boundary_;
  GhostCellMerge merge_;
  std::vector<Message> movers_;  // kept to reuse the buffers
  std::vector<int> messageTo_;   // index of the message in preparation, by rank; -1: none
  ReceiveBuffer receiveBuffer_;
  bool newPartition_ = false;  // since the last migration
  int pause_ = 0;
  double imbalance_ = 1;
  ExchangeMark mark_;  // exchange in flight
};

}  // namespace thaw
