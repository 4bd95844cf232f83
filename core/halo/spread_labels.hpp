// SPDX-License-Identifier: Apache-2.0
// Labels of connected sets of rows that may extend over several ranks.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "core/halo/halo.hpp"
#include "core/math/disjoint_sets.hpp"

namespace thaw {

inline constexpr std::uint64_t noSet = 0;  ///< label of rows that are in no set

/// Sets the label of each connected set to its smallest label, on all ranks. Sets contain owned rows and
/// copies of other ranks' rows. Rows labelled noSet are in no set. labels: by row, owned rows first.
/// exchange: sends the labels to the copies. Collective.
void spreadLabels(std::span<std::uint64_t> labels, std::size_t owned, DisjointSets& sets, Reducer& all,
                  const std::function<void()>& exchange);

}  // namespace thaw
