// SPDX-License-Identifier: Apache-2.0
#include "core/halo/serial.hpp"

#include <cmath>

namespace thaw {

void SerialReducer::maximum(std::span<double> values) {
  for (double& v : values)
    if (std::isnan(v)) v = HUGE_VAL;
}

SerialCellHalo::SerialCellHalo(const CellGrid& grid) : grid_(grid), box_{{0, 0, 0}, grid.cells} {
  checkPeriodicCells(grid_);
  images_.links = imageLinks(grid_, box_, box_, true);
}

Migration SerialCellHalo::migrate(Table& particles, std::span<const std::uint64_t>) {
  particles.resize(particles.owned, 0);
  return {};
}

void SerialCellHalo::beginGhosts(Table& particles, const CellTable& cells,
                                 std::span<AnyColumn* const> columns) {
  listBoundary(grid_, box_, cells, boundary_);
  listCopies(grid_, cells, boundary_, images_);
  beginRefresh(particles, columns);
}

void SerialCellHalo::finishGhosts(Table& particles, CellTable& cells) {
  particles.resize(particles.owned, images_.rows);
  std::size_t row = particles.owned;
  for (std::size_t c = 0; c < images_.keys.size(); c++) {
    cells.key.push_back(images_.keys[c]);
    cells.first.push_back(static_cast<std::uint32_t>(row));
    cells.count.push_back(images_.counts[c]);
    row += images_.counts[c];
  }
  merge_.merge(cells);
  finishRefresh(particles);
}

void SerialCellHalo::beginRefresh(Table&, std::span<AnyColumn* const> columns) {
  chooseColumns(columns, columns_);
  packed_.resize(images_.rows * bytesOfColumns(columns_));
  packColumns(grid_, images_, columns_, packed_.data());
}

void SerialCellHalo::finishRefresh(Table& particles) {
  unpackColumns(columns_, particles.owned, images_.rows, packed_.data());
}

}  // namespace thaw
