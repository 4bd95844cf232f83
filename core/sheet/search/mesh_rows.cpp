// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/search/mesh_rows.hpp"

#include <algorithm>

#include "core/sheet/data/sheets.hpp"

namespace thaw {

void findMeshRows(const Sheets& s, const CellTable& cells, const std::vector<SheetPlan>& plans, MeshRows& m) {
  if (m.first.empty()) {
    m.first.push_back(0);
    for (const SheetPlan& p : plans)
      m.first.push_back(m.first.back() + static_cast<std::uint32_t>(p.mesh.vertices.size()));
    m.rowOf.assign(m.first.back(), noLocalRow);
    m.wasHere.assign(m.first.back(), 0);
  }
  for (const std::uint32_t v : m.before) m.wasHere[v] = 0;
  m.before = m.numberOf;
  for (const std::uint32_t v : m.before) {
    m.rowOf[v] = noLocalRow;
    m.wasHere[v] = 1;
  }
  m.cell.resize(s.owned + s.ghosts);
  m.numberOf.resize(s.owned + s.ghosts);
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    const Vec3i cell = cellOfKey(cells.key[c]);
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) {
      const std::uint32_t v = m.first[s.id[i] >> 40] + vertexOf(s.id[i]);
      m.cell[i] = cell;
      m.numberOf[i] = v;
      m.rowOf[v] = i;
    }
  }
}

bool allAdjacent(const MeshRows& m, std::span<const std::uint32_t> rows) {
  Vec3i low = m.cell[rows[0]], high = low;
  for (const std::uint32_t r : rows)
    for (int a = 0; a < 3; a++) {
      low[a] = std::min(low[a], m.cell[r][a]);
      high[a] = std::max(high[a], m.cell[r][a]);
    }
  return high.x - low.x <= 1 && high.y - low.y <= 1 && high.z - low.z <= 1;
}

}  // namespace thaw
