// SPDX-License-Identifier: Apache-2.0
// Row ranges for passes that skip parts of a table.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thaw {

struct RowSpan {
  std::uint32_t begin, end;
};  ///< [begin, end)

/// Appends rows behind those of the list. Small gaps are included, since visiting a few extra rows costs less
/// than another range.
inline void addRows(std::vector<RowSpan>& ranges, std::size_t first, std::size_t count) {
  constexpr std::size_t little = 32;
  const auto begin = static_cast<std::uint32_t>(first), end = static_cast<std::uint32_t>(first + count);
  if (!ranges.empty() && begin <= ranges.back().end + little) ranges.back().end = end;
  else ranges.push_back({begin, end});
}

}  // namespace thaw
