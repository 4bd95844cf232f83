// SPDX-License-Identifier: Apache-2.0
// Entries of bonds, as BondGraph moves them.
#pragma once
#include "core/fields/table_rows.hpp"
#include "core/particles/solids.hpp"

namespace thaw {

inline std::size_t groupsOf(std::size_t solidIndices) { return (solidIndices + lanes - 1) / lanes; }

/// Clears entries [from, to) of a solid.
inline void clearEntries(Bonds& b, std::size_t solidIndex, int from, int to) {
  for (int k = from; k < to; k++) clearBond(b, b.at(solidIndex, k), static_cast<std::uint32_t>(solidIndex));
}

}  // namespace thaw
