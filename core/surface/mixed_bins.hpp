// Where labels meet: what asks about neighbours with other labels need not look anywhere else.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"

namespace thaw {

/// For each bin of `of`, whether there are two labels among its rows and those that `among` has within
/// `reach` (m) of them; some more may be named.
std::vector<std::uint8_t> mixedBins(const Bins& of, const std::uint64_t* ofLabel, const Bins& among,
                                    const std::uint64_t* label, double reach);

/// Calls f(row) for the rows of these bins.
template<class F> void forMixed(const Bins& bins, const std::vector<std::uint8_t>& mixed, F f) {
  for (std::size_t b = 0; b < bins.size(); b++)
    for (std::uint32_t k = bins.first[b]; mixed[b] && k < bins.first[b + 1]; k++) f(bins.row[k]);
}

}  // namespace thaw
