// SPDX-License-Identifier: Apache-2.0
// Halos of a single process, for tests and tools without MPI. Ghosts are periodic images of its own cells.
#pragma once
#include "core/halo/cell_copies.hpp"
#include "core/halo/halo.hpp"
#include "core/halo/surface_halos.hpp"

namespace thaw {

class SerialReducer : public Reducer {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  /// NaN becomes +infinity, as over MPI.
  void maximum(std::span<double> values) override;
  void sum(std::span<std::int64_t>) override {}
  std::vector<WordStream> sparseAllToAll(std::vector<WordStream> lists) override { return lists; }
};

class SerialCellHalo : public CellHalo {
 public:
  /// Throws std::invalid_argument for a periodic axis of fewer than three cells, where images would overlap.
  explicit SerialCellHalo(const CellGrid& grid);

  Migration migrate(Table& particles, std::span<const std::uint64_t> keys) override;
  void beginGhosts(Table& particles, const CellTable& cells, std::span<AnyColumn* const> columns) override;
  void finishGhosts(Table& particles, CellTable& cells) override;
  void beginRefresh(Table& particles, std::span<AnyColumn* const> columns) override;
  void finishRefresh(Table& particles) override;
  bool rebalance(const CellTable&, std::span<const double>, bool) override { return false; }
  void follow(const CellHalo&) override {}
  bool owns(std::uint64_t key) const override { return box_.contains(cellOfKey(key)); }
  bool inner(std::uint64_t key) const override { return innerCell(grid_, box_, cellOfKey(key)); }

 private:
  CellGrid grid_;
  CellBox box_;
  CellCopies images_;
  std::vector<std::uint32_t> boundary_;
  std::vector<AnyColumn*> columns_;  // columns of the exchange in flight
  std::vector<std::byte> packed_;
  GhostCellMerge merge_;
};

class SerialRowScatter : public RowScatter {
 public:
  void scatterBack(std::span<const std::uint64_t> source, std::span<const std::uint64_t> values,
                   std::span<std::uint64_t> here) override {
    for (std::size_t k = 0; k < source.size(); k++) here[source[k] & 0xffffffffu] = values[k];
  }
};

/// The halos of a surface in a single process.
struct SerialSurfaceRanks {
  SerialReducer all;
  SerialCellHalo surfels, particles;
  SerialRowScatter scatter;
  explicit SerialSurfaceRanks(const CellGrid& grid) : surfels(grid), particles(grid) {}
  SurfaceHalos halos() { return {all, surfels, particles, scatter}; }
};

}  // namespace thaw
