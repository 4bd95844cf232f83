// Copies of cells that one rank holds of another's, or of its own as periodic images: which cells, which
// rows, packed columns. Used by the halo over MPI and by the serial one.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/cell_box.hpp"
#include "core/particles/column.hpp"

namespace thaw {

/// Cells of the owner's box that the receiver sees `shift` domains away.
struct ImageLink {
  CellBox region;
  Vec3i shift;
};

/// Rows [first, first + count), in the owner's table, that are seen `shift` domains away.
struct RowRun {
  std::uint32_t first, count;
  Vec3i shift;
};

/// Everything of one owner that one receiver copies. Cells and rows are renewed by listCopies, links stay
/// until the boxes change.
struct CellCopies {
  std::vector<ImageLink> links;
  std::vector<std::uint64_t> keys;    ///< of the cells, as the receiver sees them
  std::vector<std::uint32_t> counts;  ///< rows of each cell
  std::vector<RowRun> runs;           ///< rows of all these cells, in their order
  std::size_t rows = 0;
};

/// Throws std::invalid_argument for a periodic axis of fewer than three cells: a cell would meet its own
/// image.
void checkPeriodicCells(const CellGrid& grid);

/// Parts of `owner` that touch `receiver`, periodic images included; same: they are one rank, which needs
/// images only.
std::vector<ImageLink> imageLinks(const CellGrid& grid, const CellBox& owner, const CellBox& receiver,
                                  bool same);

/// Fills in keys, counts and runs of the copies of those cells.
void listCopies(const CellGrid& grid, const CellTable& cells, std::span<const std::uint32_t> candidates,
                CellCopies& copies);

/// Indices of the owned cells that have copies somewhere: those of `box` that are not inner.
void listBoundary(const CellGrid& grid, const CellBox& box, const CellTable& cells,
                  std::vector<std::uint32_t>& boundary);

/// Those that are active, for an exchange. Throws std::logic_error for one that ghosts do not have.
void chooseColumns(std::span<AnyColumn* const> columns, std::vector<AnyColumn*>& active);

/// Bytes of one row in these columns.
std::size_t bytesOfColumns(std::span<AnyColumn* const> columns);

/// Writes the copied rows of one column behind another to `to` (rows * bytesOfColumns). "position" is shifted
/// by the period.
void packColumns(const CellGrid& grid, const CellCopies& copies, std::span<AnyColumn* const> columns,
                 std::byte* to);
/// Puts what packColumns wrote into rows [first, first + count).
void unpackColumns(std::span<AnyColumn* const> columns, std::size_t first, std::size_t count,
                   const std::byte* from);

/// Ghost cells that were appended behind the owned ones move to their places in the order of keys. Buffers
/// are kept.
class GhostCellMerge {
 public:
  void merge(CellTable& cells);

 private:
  CellTable merged_;
  std::vector<std::uint32_t> order_;
};

}  // namespace thaw
