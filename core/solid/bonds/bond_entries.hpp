// SPDX-License-Identifier: Apache-2.0
// Operations on one entry in the arrays of Bonds.
#pragma once
#include "core/solid/bonds/bond_records.hpp"

namespace thaw {

inline void copyBond(Bonds& b, std::size_t from, std::size_t to) {
  b.neighbour[to] = b.neighbour[from];
  b.eachReal([&](BondReals& r) { r.set(to, r[from]); });
}

/// Clears an entry. It gets the weight 0, and `self` as its readable end.
inline void clearBond(Bonds& b, std::size_t at, std::uint32_t self) {
  b.neighbour[at] = self;
  b.eachReal([&](BondReals& r) { r.set(at, 0); });
}

inline void putBond(Bonds& b, std::size_t at, std::uint32_t neighbour, const BondRecord& r) {
  b.neighbour[at] = neighbour;
  if (!b.vectors) return;
  b.x.set(at, r.reference[0]), b.y.set(at, r.reference[1]), b.z.set(at, r.reference[2]);
  if (b.twoFrames) b.rx.set(at, r.reverse[0]), b.ry.set(at, r.reverse[1]), b.rz.set(at, r.reverse[2]);
  b.weight.set(at, r.weight);
}

}  // namespace thaw
