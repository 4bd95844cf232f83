// SPDX-License-Identifier: Apache-2.0
// Copies of the cells of another rank, or of periodic images: their keys, rows and packed columns. Both the
// MPI halo and the serial halo use this file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/column.hpp"
#include "core/halo/cell_box.hpp"

namespace thaw {

/// Cells of the owner's box, shifted by `shift` domains at the receiver.
struct ImageLink {
  CellBox region;
  Vec3i shift;
};

/// Rows [first, first + count) of the owner's table, shifted by `shift` domains.
struct RowRun {
  std::uint32_t first, count;
  Vec3i shift;
};

/// All copies from one owner for one receiver. listCopies updates cells and rows. The links are constant
/// until the boxes change.
struct CellCopies {
  std::vector<ImageLink> links;
  std::vector<std::uint64_t> keys;    ///< keys of the cells at the receiver
  std::vector<std::uint32_t> counts;  ///< number of rows of each cell
  std::vector<RowRun> runs;           ///< rows of all copied cells, in order
  std::size_t rows = 0;
};

/// Throws std::invalid_argument for a periodic axis of fewer than three cells, where a cell would touch its
/// own image.
void checkPeriodicCells(const CellGrid& grid);

/// Returns the parts of `owner` that touch `receiver`, periodic images included. same: owner and receiver are
/// the same rank, which needs only periodic images.
std::vector<ImageLink> imageLinks(const CellGrid& grid, const CellBox& owner, const CellBox& receiver,
                                  bool same);

/// Fills in keys, counts and runs of the copied cells.
void listCopies(const CellGrid& grid, const CellTable& cells, std::span<const std::uint32_t> candidates,
                CellCopies& copies);

/// Lists the indices of the owned cells with copies elsewhere: cells of `box` that are not inner.
void listBoundary(const CellGrid& grid, const CellBox& box, const CellTable& cells,
                  std::vector<std::uint32_t>& boundary);

/// Selects the active columns for an exchange. Throws std::logic_error for a column without ghost rows.
void chooseColumns(std::span<AnyColumn* const> columns, std::vector<AnyColumn*>& active);

/// Returns the bytes of one row in these columns.
std::size_t bytesOfColumns(std::span<AnyColumn* const> columns);

/// Writes the copied rows column by column to `to` (rows * bytesOfColumns bytes). The column "position" is
/// shifted by the period.
void packColumns(const CellGrid& grid, const CellCopies& copies, std::span<AnyColumn* const> columns,
                 std::byte* to);
/// Reads the output of packColumns into rows [first, first + count).
void unpackColumns(std::span<AnyColumn* const> columns, std::size_t first, std::size_t count,
                   const std::byte* from);

/// Moves ghost cells, which were appended behind the owned cells, to their positions in key order. Buffers
/// are reused.
class GhostCellMerge {
 public:
  void merge(CellTable& cells);

 private:
  CellTable merged_;
  std::vector<std::uint32_t> order_;
};

}  // namespace thaw
