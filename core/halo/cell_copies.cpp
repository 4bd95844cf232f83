// SPDX-License-Identifier: Apache-2.0
#include "core/halo/cell_copies.hpp"

#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>

namespace thaw {
namespace {

Vec3i domains(const CellGrid& g, const Vec3i& s) {
  return {s.x * g.cells.x, s.y * g.cells.y, s.z * g.cells.z};
}

bool isPosition(const AnyColumn& c) {
  return c.elementBytes == sizeof(Vec3d) && std::strcmp(c.name, "position") == 0;
}

void shiftPositions(const CellGrid& grid, const RowRun& run, std::byte* at) {
  const Vec3d by{run.shift.x * grid.period.x, run.shift.y * grid.period.y, run.shift.z * grid.period.z};
  for (std::uint32_t k = 0; k < run.count; k++, at += sizeof(Vec3d)) {
    Vec3d x;
    std::memcpy(&x, at, sizeof x);
    x += by;
    std::memcpy(at, &x, sizeof x);
  }
}

}  // namespace

void checkPeriodicCells(const CellGrid& grid) {
  for (int a = 0; a < 3; a++)
    if (grid.periodic[a] && grid.cells[a] < 3)
      throw std::invalid_argument(
          "the domain is periodic along " + std::string(1, static_cast<char>('x' + a)) + " and has " +
          std::to_string(grid.cells[a]) + " cells (support radii) along it; expected at least 3");
}

std::vector<ImageLink> imageLinks(const CellGrid& grid, const CellBox& owner, const CellBox& receiver,
                                  bool same) {
  std::vector<ImageLink> links;
  if (owner.empty() || receiver.empty()) return links;
  const CellBox wanted = grown(receiver);
  Vec3i s, reach;
  for (int a = 0; a < 3; a++) reach[a] = grid.periodic[a] ? 1 : 0;
  for (s.z = -reach.z; s.z <= reach.z; s.z++)
    for (s.y = -reach.y; s.y <= reach.y; s.y++)
      for (s.x = -reach.x; s.x <= reach.x; s.x++) {
        if (same && s == Vec3i{}) continue;
        // The owner's cell c appears at c + s domains.
        const CellBox region = common(owner, moved(wanted, -domains(grid, s)));
        if (!region.empty()) links.push_back({region, s});
      }
  return links;
}

void listBoundary(const CellGrid& grid, const CellBox& box, const CellTable& cells,
                  std::vector<std::uint32_t>& boundary) {
  boundary.clear();
  for (std::size_t c = 0; c < cells.key.size(); c++)
    if (!innerCell(grid, box, cellOfKey(cells.key[c]))) boundary.push_back(static_cast<std::uint32_t>(c));
}

void listCopies(const CellGrid& grid, const CellTable& cells, std::span<const std::uint32_t> candidates,
                CellCopies& copies) {
  copies.keys.clear();
  copies.counts.clear();
  copies.runs.clear();
  copies.rows = 0;
  for (const std::uint32_t c : candidates) {
    const Vec3i cell = cellOfKey(cells.key[c]);
    const std::uint32_t first = cells.first[c], count = cells.count[c];
    for (const ImageLink& link : copies.links) {
      if (!link.region.contains(cell)) continue;
      copies.keys.push_back(cellKey(cell + domains(grid, link.shift)));
      copies.counts.push_back(count);
      copies.rows += count;
      RowRun* last = copies.runs.empty() ? nullptr : &copies.runs.back();
      if (last != nullptr && last->first + last->count == first && last->shift == link.shift)
        last->count += count;
      else copies.runs.push_back({first, count, link.shift});
    }
  }
}

void chooseColumns(std::span<AnyColumn* const> columns, std::vector<AnyColumn*>& active) {
  active.clear();
  for (AnyColumn* c : columns) {
    if (c->rows == Rows::Owned)
      throw std::logic_error(std::string("ghost rows do not have the field ") + c->name);
    if (c->active) active.push_back(c);
  }
}

std::size_t bytesOfColumns(std::span<AnyColumn* const> columns) {
  std::size_t bytes = 0;
  for (const AnyColumn* c : columns) bytes += c->elementBytes;
  return bytes;
}

void packColumns(const CellGrid& grid, const CellCopies& copies, std::span<AnyColumn* const> columns,
                 std::byte* to) {
  for (const AnyColumn* c : columns) {
    const std::byte* const from = c->bytes.data();
    const bool position = isPosition(*c);
    for (const RowRun& run : copies.runs) {
      std::memcpy(to, from + run.first * c->elementBytes, run.count * c->elementBytes);
      if (position && !(run.shift == Vec3i{})) shiftPositions(grid, run, to);
      to += run.count * c->elementBytes;
    }
  }
}

void unpackColumns(std::span<AnyColumn* const> columns, std::size_t first, std::size_t count,
                   const std::byte* from) {
  if (count == 0) return;
  for (AnyColumn* c : columns) {
    std::memcpy(c->bytes.data() + first * c->elementBytes, from, count * c->elementBytes);
    from += count * c->elementBytes;
  }
}

void GhostCellMerge::merge(CellTable& cells) {
  const std::size_t all = cells.key.size(), owned = cells.ownedCells;
  if (all == owned) return;
  order_.resize(all - owned);
  std::iota(order_.begin(), order_.end(), static_cast<std::uint32_t>(owned));
  std::sort(order_.begin(), order_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return cells.key[a] < cells.key[b]; });
  merged_.key.clear();
  merged_.first.clear();
  merged_.count.clear();
  const auto put = [&](std::size_t c) {
    merged_.key.push_back(cells.key[c]);
    merged_.first.push_back(cells.first[c]);
    merged_.count.push_back(cells.count[c]);
  };
  std::size_t next = 0;
  for (const std::uint32_t ghost : order_) {
    for (; next < owned && cells.key[next] < cells.key[ghost]; next++) put(next);
    put(ghost);
  }
  for (; next < owned; next++) put(next);
  cells.key.swap(merged_.key);
  cells.first.swap(merged_.first);
  cells.count.swap(merged_.count);
}

}  // namespace thaw
