// CellHalo over MPI: migration, ghosts and periodic images, load balance.
#pragma once
#include <cstdint>
#include <vector>

#include "parallel/decomposition.hpp"

namespace thaw {

struct BalanceRule {
  double threshold = 1.1;  ///< largest over mean cost above which a new partition is tried
  double gain = 0.95;      ///< it is taken if its imbalance is below this times the present one
};

struct HaloTraffic { std::int64_t messages = 0, bytes = 0; };

class MpiCellHalo : public CellHalo {
 public:
  MpiCellHalo(const Communicator& comm, const CellGrid& grid, const BalanceRule& rule = {});

  Migration migrate(Table& particles, std::span<const std::uint64_t> keys) override;
  void beginGhosts(Table& particles, const CellTable& cells, std::span<AnyColumn* const> columns) override;
  void finishGhosts(Table& particles, CellTable& cells) override;
  void beginRefresh(Table& particles, std::span<AnyColumn* const> columns) override;
  void finishRefresh(Table& particles) override;
  bool rebalance(const CellTable& ownedCells, std::span<const double> cost, bool force) override;
  bool owns(std::uint64_t key) const override { return box_.contains(cellOfKey(key)); }
  bool inner(std::uint64_t key) const override;

  const std::vector<CellBox>& boxes() const { return boxes_; }
  const HaloTraffic& traffic() const { return traffic_; }

 private:
  /// Part of a neighbour's surroundings that lies in our box: these cells go there, moved by `shift` periods.
  struct Link { CellBox region; Vec3i shift; };
  /// Everything exchanged with one rank (or, as images, with ourselves).
  struct Neighbour {
    int rank = 0;
    std::vector<Link> links;
    std::vector<std::uint64_t> keys;          // of the cells sent, as the receiver sees them
    std::vector<std::uint32_t> counts, rows;  // particles of each cell; rows of all of them
    std::vector<std::uint8_t> shift;          // index of the link of each row
    std::size_t ghostFirst = 0, ghostCount = 0;  // rows received
    std::vector<std::byte> out, in;
    std::size_t sendRoom = 1 << 16, receiveRoom = 1 << 16;  // both ends keep the same figures
    MPI_Request requests[2] = {MPI_REQUEST_NULL, MPI_REQUEST_NULL};
  };
  void findNeighbours();
  void listCells(const CellTable& cells);
  void pack(Neighbour& n, std::span<AnyColumn* const> columns, std::byte* to) const;
  void unpack(const Neighbour& n, const std::byte* from) const;

  const Communicator& comm_;
  CellGrid grid_;
  BalanceRule rule_;
  std::vector<CellBox> boxes_;
  CellBox box_;
  std::vector<Neighbour> neighbours_;
  std::vector<AnyColumn*> columns_;  // of the exchange under way
  CellTable merged_;
  std::vector<std::uint32_t> cellOrder_;
  HaloTraffic traffic_;
};

}  // namespace thaw
