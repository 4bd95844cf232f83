#include "core/surface/bins.hpp"

#include <array>

namespace thaw {
namespace {

using Sorting = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

/// By key, rows of one key as they stand: digit by digit, for numbers below 2^bits.
void sortByKey(Sorting& v, Sorting& other, int bits) {
  constexpr int digit = 12;
  std::array<std::uint32_t, 1 << digit> count;
  other.resize(v.size());
  for (int shift = 0; shift < bits; shift += digit) {
    count.fill(0);
    for (const auto& [key, row] : v) count[key >> shift & ((1 << digit) - 1)]++;
    std::uint32_t sum = 0;
    for (std::uint32_t& c : count) sum += std::exchange(c, sum);
    for (const auto& entry : v) other[count[entry.first >> shift & ((1 << digit) - 1)]++] = entry;
    v.swap(other);
  }
}

void listBins(Bins& b) {
  b.key.clear();
  b.first.clear();
  b.line.clear();
  b.firstBin.clear();
  for (std::size_t k = 0; k < b.sorting.size(); k++) {
    const std::uint64_t key = b.sorting[k].first;
    if (!b.key.empty() && b.key.back() == key) continue;
    if (b.line.empty() || b.line.back() != key >> 21) b.line.push_back(key >> 21), b.firstBin.push_back(static_cast<std::uint32_t>(b.key.size()));
    b.key.push_back(key);
    b.first.push_back(static_cast<std::uint32_t>(k));
  }
  b.first.push_back(static_cast<std::uint32_t>(b.sorting.size()));
  b.firstBin.push_back(static_cast<std::uint32_t>(b.key.size()));
}

void roundPlaces(Bins& b) {
  b.x.resize(b.at.size()), b.y.resize(b.at.size()), b.z.resize(b.at.size());
  for (std::size_t k = 0; k < b.at.size(); k++) {
    const Vec3d d = b.at[k] - b.base;
    b.x[k] = static_cast<float>(d.x), b.y[k] = static_cast<float>(d.y), b.z[k] = static_cast<float>(d.z);
  }
}

std::uint64_t keyOf(const Bins& b, const Vec3d& x) { return binKey(binOf(b, x.x, 0), binOf(b, x.y, 1), binOf(b, x.z, 2)); }
std::uint64_t part(std::uint64_t key, int axis) { return key >> 21 * axis & 0x1fffff; }

/// Rows with their keys, which keep their order within a bin.
void sortIntoBins(const Vec3d* position, Bins& b) {
  std::uint64_t low[3]{~0ull, ~0ull, ~0ull}, high[3]{};
  for (const auto& entry : b.sorting)
    for (int a = 0; a < 3; a++) low[a] = std::min(low[a], part(entry.first, a)), high[a] = std::max(high[a], part(entry.first, a));
  const std::uint64_t nx = high[0] - low[0] + 1, ny = high[1] - low[1] + 1, nz = high[2] - low[2] + 1;
  if (b.sorting.size() > 64 && static_cast<double>(nx) * static_cast<double>(ny) * static_cast<double>(nz) < 1e13) {
    for (auto& [key, row] : b.sorting) key = ((part(key, 2) - low[2]) * ny + part(key, 1) - low[1]) * nx + part(key, 0) - low[0];
    int bits = 0;
    while ((nx * ny * nz - 1) >> bits) bits++;
    sortByKey(b.sorting, b.sorted, bits);
    for (auto& [key, row] : b.sorting) key = binKey(key % nx + low[0], key / nx % ny + low[1], key / nx / ny + low[2]);
  } else {
    std::stable_sort(b.sorting.begin(), b.sorting.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  }
  b.row.resize(b.sorting.size());
  b.at.resize(b.sorting.size());
  for (std::size_t k = 0; k < b.sorting.size(); k++) b.row[k] = b.sorting[k].second, b.at[k] = position[b.row[k]];
  roundPlaces(b);
  listBins(b);
}

}  // namespace

void fillBins(const CellGrid& grid, const CellTable& cells, const Vec3d* position, double edge, Bins& b) {
  double longest = 0;
  for (int a = 0; a < 3; a++) {
    b.base[a] = grid.origin[a] - grid.edge[a];  // images lie up to a cell outside
    longest = std::max(longest, (grid.cells[a] + 2) * grid.edge[a]);
  }
  b.perLength = 1 / std::max(edge, longest / (binsPerAxis - 1));
  b.sorting.clear();
  for (std::size_t c = 0; c < cells.key.size(); c++)
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) b.sorting.emplace_back(keyOf(b, position[i]), i);
  // rows of a bin stay in the order of cells and ids: owned and ghost rows of two cells may stand in any order in the table
  sortIntoBins(position, b);
}

void fillBins(const Vec3d* position, std::size_t n, double edge, Bins& b) {
  b.base = n > 0 ? position[0] : Vec3d{};
  for (std::size_t i = 1; i < n; i++)
    for (int a = 0; a < 3; a++) b.base[a] = std::min(b.base[a], position[i][a]);
  b.perLength = 1 / edge;
  b.sorting.clear();
  for (std::size_t i = 0; i < n; i++) b.sorting.emplace_back(keyOf(b, position[i]), static_cast<std::uint32_t>(i));
  sortIntoBins(position, b);
}

void pickRows(const Bins& b, const std::uint8_t* keep, Bins& to) {
  to.base = b.base;
  to.perLength = b.perLength;
  to.sorting.clear();
  to.row.clear();
  to.at.clear();
  for (std::size_t bin = 0; bin < b.size(); bin++)
    for (std::uint32_t k = b.first[bin]; k < b.first[bin + 1]; k++) {
      if (!keep[b.row[k]]) continue;
      to.sorting.emplace_back(b.key[bin], b.row[k]);
      to.row.push_back(b.row[k]);
      to.at.push_back(b.at[k]);
    }
  roundPlaces(to);
  listBins(to);
}

}  // namespace thaw
