// One place in the arrays of Bonds: copy, clear, fill.
#pragma once
#include "core/solid/bond_records.hpp"

namespace thaw {

inline void copyBond(Bonds& b, std::size_t from, std::size_t to) {
  b.neighbour[to] = b.neighbour[from];
  b.x[to] = b.x[from], b.y[to] = b.y[from], b.z[to] = b.z[from];
  b.weight[to] = b.weight[from];
  if (b.twoFrames) b.rx[to] = b.rx[from], b.ry[to] = b.ry[from], b.rz[to] = b.rz[from];
}

/// No bond: weight 0 and an end that may be read, `self`.
inline void clearBond(Bonds& b, std::size_t at, std::uint32_t self) {
  b.neighbour[at] = self;
  b.weight[at] = b.x[at] = b.y[at] = b.z[at] = 0;
  if (b.twoFrames) b.rx[at] = b.ry[at] = b.rz[at] = 0;
}

inline void putBond(Bonds& b, std::size_t at, std::uint32_t neighbour, const BondRecord& r) {
  b.neighbour[at] = neighbour;
  b.x[at] = r.reference[0], b.y[at] = r.reference[1], b.z[at] = r.reference[2];
  if (b.twoFrames) b.rx[at] = r.reverse[0], b.ry[at] = r.reverse[1], b.rz[at] = r.reverse[2];
  b.weight[at] = r.weight;
}

}  // namespace thaw
