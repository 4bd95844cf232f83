// Rows of the solids' tables and places of bonds, as BondGraph moves them.
#pragma once
#include "core/solid/solids.hpp"

namespace thaw {

inline std::size_t groupsOf(std::size_t slots) { return (slots + lanes - 1) / lanes; }

inline void copyRow(Table& t, std::size_t from, std::size_t to) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memcpy(c->bytes.data() + to * c->elementBytes, c->bytes.data() + from * c->elementBytes, c->elementBytes);
}

inline void clearRow(Table& t, std::size_t row) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memset(c->bytes.data() + row * c->elementBytes, 0, c->elementBytes);
}

/// Places [from, to) of a slot hold no bond.
inline void clearPlaces(Bonds& b, std::size_t slot, int from, int to) {
  for (int k = from; k < to; k++) clearBond(b, b.at(slot, k), static_cast<std::uint32_t>(slot));
}

}  // namespace thaw
