#include "core/surface/bins.hpp"

namespace thaw {

void fillBins(const CellGrid& grid, const CellTable& cells, const Vec3d* position, double edge, Bins& b) {
  double longest = 0;
  for (int a = 0; a < 3; a++) {
    b.base[a] = grid.origin[a] - grid.edge[a];  // images lie up to a cell outside
    longest = std::max(longest, (grid.cells[a] + 2) * grid.edge[a]);
  }
  b.perLength = 1 / std::max(edge, longest / (binsPerAxis - 1));
  b.sorting.clear();
  for (std::size_t c = 0; c < cells.key.size(); c++)
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++)
      b.sorting.emplace_back(binKey(binOf(b, position[i].x, 0), binOf(b, position[i].y, 1), binOf(b, position[i].z, 2)), i);
  // rows of a bin stay in the order of cells and ids: owned and ghost rows of two cells may stand in any order in the table
  std::stable_sort(b.sorting.begin(), b.sorting.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  b.key.resize(b.sorting.size());
  b.row.resize(b.sorting.size());
  b.at.resize(b.sorting.size());
  for (std::size_t k = 0; k < b.sorting.size(); k++) b.key[k] = b.sorting[k].first, b.row[k] = b.sorting[k].second, b.at[k] = position[b.row[k]];
}

}  // namespace thaw
