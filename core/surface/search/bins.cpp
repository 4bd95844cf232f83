// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/bins.hpp"

#include <array>
#include <bit>

#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {

void sortByKey(SortedRows& v, SortedRows& other, int bits) {
  constexpr int digit = 11;
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

namespace {

void listBins(Bins& b) {
  b.key.clear();
  b.first.clear();
  b.line.clear();
  b.firstBin.clear();
  for (std::size_t k = 0; k < b.sorting.size(); k++) {
    const std::uint64_t key = b.sorting[k].first;
    if (!b.key.empty() && b.key.back() == key) continue;
    if (b.line.empty() || b.line.back() != key >> 21)
      b.line.push_back(key >> 21), b.firstBin.push_back(static_cast<std::uint32_t>(b.key.size()));
    b.key.push_back(key);
    b.first.push_back(static_cast<std::uint32_t>(k));
  }
  b.first.push_back(static_cast<std::uint32_t>(b.sorting.size()));
  b.firstBin.push_back(static_cast<std::uint32_t>(b.key.size()));
}

void roundPlaces(Bins& b) {
  for (auto* v : {&b.x, &b.y, &b.z}) v->resize(b.at.size() + nearBoxMore);
  for (std::size_t k = 0; k < b.at.size(); k++) {
    const Vec3d d = b.at[k] - b.base;
    b.x[k] = static_cast<float>(d.x), b.y[k] = static_cast<float>(d.y), b.z[k] = static_cast<float>(d.z);
  }
}

std::uint64_t keyOf(const Bins& b, const Vec3d& x) {
  return binKey(binOf(b, x.x, 0), binOf(b, x.y, 1), binOf(b, x.z, 2));
}
std::uint64_t part(std::uint64_t key, int axis) { return key >> 21 * axis & 0x1fffff; }

/// Sorts rows by bin. Rows of a bin keep their order.
void sortIntoBins(const Vec3d* position, Bins& b) {
  std::uint64_t low[3]{~0ull, ~0ull, ~0ull}, high[3]{};
  for (const auto& entry : b.sorting)
    for (int a = 0; a < 3; a++)
      low[a] = std::min(low[a], part(entry.first, a)), high[a] = std::max(high[a], part(entry.first, a));
  // number of bits of the bin numbers, relative to the lowest bin
  std::array<int, 3> bits{};
  for (std::size_t a = 0; a < 3; a++) bits[a] = std::bit_width(high[a] - low[a]);
  if (b.sorting.size() > 64) {
    const int y = bits[0], z = bits[0] + bits[1];
    for (auto& [key, row] : b.sorting)
      key = (part(key, 2) - low[2]) << z | (part(key, 1) - low[1]) << y | (part(key, 0) - low[0]);
    sortByKey(b.sorting, b.sorted, z + bits[2]);
    const auto lowBits = [](std::uint64_t v, int n) { return v & ((std::uint64_t{1} << n) - 1); };
    for (auto& [key, row] : b.sorting)
      key = binKey(lowBits(key, y) + low[0], lowBits(key >> y, bits[1]) + low[1], (key >> z) + low[2]);
  } else {
    std::stable_sort(b.sorting.begin(), b.sorting.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
  }
  b.row.resize(b.sorting.size());
  b.at.resize(b.sorting.size());
  for (std::size_t k = 0; k < b.sorting.size(); k++)
    b.row[k] = b.sorting[k].second, b.at[k] = position[b.row[k]];
  roundPlaces(b);
  listBins(b);
}

/// Converts a box and a distance to floats relative to the base of the bins. The distance is enlarged by the
/// rounding error.
NearBox nearBoxOf(const PlaceBox& box, const Vec3d& base, double radius) {
  const Vec3d middle = 0.5 * (box.low + box.high) - base, half = 0.5 * (box.high - box.low);
  const double rounding = 1e-6 * (std::abs(middle.x) + std::abs(middle.y) + std::abs(middle.z) + half.x +
                                  half.y + half.z + radius),
               reach = radius + rounding;
  NearBox near{};
  for (int a = 0; a < 3; a++)
    near.middle[a] = static_cast<float>(middle[a]), near.half[a] = static_cast<float>(half[a]);
  near.reach2 = static_cast<float>(reach * reach);
  return near;
}

}  // namespace

void RowBlock::find(const Bins& bins, const PlaceBox& box, double radius) {
  const NearBox near = nearBoxOf(box, bins.base, radius);
  base_ = bins.base;
  count = 0;
  forBinRunsAround(bins, box.low, box.high, radius, [&](std::size_t from, std::size_t to) {
    const std::uint32_t begin = bins.first[from], many = bins.first[to] - begin;
    if (row.size() < count + many + nearBoxMore) {
      row.resize(2 * (count + many) + nearBoxMore), at.resize(row.size());
      for (auto* v : {&x, &y, &z}) v->resize(row.size());
    }
    const std::size_t end = count + bestSurfaceKernels().nearBox(near, &bins.x[begin], &bins.y[begin],
                                                                 &bins.z[begin], many, &row[count]);
    for (; count < end; count++) {
      const std::uint32_t k = begin + row[count];
      row[count] = bins.row[k];
      at[count] = bins.at[k];
      x[count] = bins.x[k], y[count] = bins.y[k], z[count] = bins.z[k];
    }
  });
}

std::span<const std::uint32_t> RowBlock::around(const Vec3d& place, double radius) {
  if (picked_.size() < row.size() + nearBoxMore) picked_.resize(row.size() + nearBoxMore);
  if (count == 0) return {};
  return {picked_.data(),
          bestSurfaceKernels().nearBox(nearBoxOf({place, place}, base_, radius), x.data(), y.data(), z.data(),
                                       static_cast<std::uint32_t>(count), picked_.data())};
}

void fillBins(const CellGrid& grid, const CellTable& cells, const Vec3d* position, double edge, Bins& b) {
  double longest = 0;
  for (int a = 0; a < 3; a++) {
    // periodic images lie up to a cell outside of the domain
    b.base[a] = grid.origin[a] - grid.edge[a];
    longest = std::max(longest, (grid.cells[a] + 2) * grid.edge[a]);
  }
  b.perLength = 1 / std::max(edge, longest / (binsPerAxis - 1));
  b.sorting.clear();
  for (std::size_t c = 0; c < cells.key.size(); c++)
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++)
      b.sorting.emplace_back(keyOf(b, position[i]), i);
  // Rows of a bin stay in the order of cells and ids. Owned and ghost rows of two cells may have any order in
  // the table.
  sortIntoBins(position, b);
}

void fillBins(const Vec3d* position, std::size_t n, double edge, Bins& b) {
  b.base = n > 0 ? position[0] : Vec3d{};
  for (std::size_t i = 1; i < n; i++)
    for (int a = 0; a < 3; a++) b.base[a] = std::min(b.base[a], position[i][a]);
  b.perLength = 1 / edge;
  b.sorting.clear();
  for (std::size_t i = 0; i < n; i++)
    b.sorting.emplace_back(keyOf(b, position[i]), static_cast<std::uint32_t>(i));
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
