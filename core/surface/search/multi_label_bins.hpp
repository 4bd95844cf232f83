// SPDX-License-Identifier: Apache-2.0
// Finds bins near several labels, to restrict searches for neighbours with other labels.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/search/bins.hpp"

namespace thaw {

/// Returns for each bin of `of` whether its rows and those of `among` within `reach` (m) have at least two
/// labels. Some more bins may be flagged.
std::vector<std::uint8_t> multiLabelBins(const Bins& of, const std::uint64_t* ofLabel, const Bins& among,
                                         const std::uint64_t* label, double reach);

/// Calls f(row) for the rows of the flagged bins.
template<class F> void forMultiLabel(const Bins& bins, const std::vector<std::uint8_t>& mixed, F f) {
  for (std::size_t b = 0; b < bins.size(); b++)
    for (std::uint32_t k = bins.first[b]; mixed[b] && k < bins.first[b + 1]; k++) f(bins.row[k]);
}

}  // namespace thaw
