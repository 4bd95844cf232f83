// SPDX-License-Identifier: Apache-2.0
#include "core/surface/data/remove_surfels.hpp"

namespace thaw {

std::int64_t removeSurfels(Surface& s, std::span<const std::uint8_t> dead) {
  Surfels& f = s.surfels;
  std::vector<std::uint32_t> kept;
  kept.reserve(f.owned);
  for (std::size_t i = 0; i < f.owned; i++)
    if (!dead[i]) kept.push_back(static_cast<std::uint32_t>(i));
  const std::size_t gone = f.owned - kept.size();
  f.resize(f.owned, 0);
  if (gone > 0) f.reorder(kept);
  CellTable& cells = s.surfelCells;
  cells.key.clear();
  cells.first.clear();
  cells.count.clear();
  for (std::size_t i = 0; i < f.owned; i++) {
    if (cells.key.empty() || cells.key.back() != f.cell[i]) {
      cells.key.push_back(f.cell[i]);
      cells.first.push_back(static_cast<std::uint32_t>(i));
      cells.count.push_back(0);
    }
    cells.count.back()++;
  }
  cells.ownedCells = cells.key.size();
  return static_cast<std::int64_t>(gone);
}

}  // namespace thaw
