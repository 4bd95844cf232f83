// SPDX-License-Identifier: Apache-2.0
// Bonds of the owned solids. If no reference ever changes (no freezing, welding or large plastic flow), all
// bonds share one configuration. A bond then stores only its other end. X_ij is the difference of the two
// Solids::reference, and the weight follows from the length of X_ij. Otherwise each bond stores its vectors
// and weight, in the precision of the elastic step.
#pragma once
#include <algorithm>
#include <type_traits>

#include "core/fields/column.hpp"

namespace thaw {

inline constexpr int lanes = 8;  ///< bonds and neighbour lists are interleaved by groups of 8 rows (sliced
                                 ///< ELLPACK)

/// An array of reals in single or double precision.
class BondReals {
 public:
  bool single = false;  ///< may be set only while the array is empty
  double operator[](std::size_t at) const { return single ? static_cast<double>(f_[at]) : d_[at]; }
  void set(std::size_t at, double value) {
    if (single) f_[at] = static_cast<float>(value);
    else d_[at] = value;
  }
  std::size_t size() const { return single ? f_.size() : d_.size(); }
  std::size_t bytes() const { return f_.capacity() * sizeof(float) + d_.capacity() * sizeof(double); }
  const void* data() const { return single ? static_cast<const void*>(f_.data()) : d_.data(); }
  /// Calls use(vector) with the vector of this precision.
  template<class Use> void with(Use&& use) { single ? use(f_) : use(d_); }
  void assign(std::size_t n, double value) {
    with([&](auto& v) {
      v.assign(n, static_cast<typename std::remove_reference_t<decltype(v)>::value_type>(value));
    });
  }

 private:
  AlignedVector<float> f_;
  AlignedVector<double> d_;
};

/// Bond k of solid s is element at(s, k) of each array. The order of a solid's bonds is part of the state: it
/// is the order of sums, equal on any number of ranks.
struct Bonds {
  int capacity = 0;                        ///< bonds per solid; grows as needed
  AlignedVector<std::uint32_t> neighbour;  ///< solid at the other end; unused entries hold a readable
                                           ///< row, that of the solid itself if it is owned
  BondReals x, y, z;  ///< reference vector X_ij (m) from this end to the other, in this end's reference frame
  BondReals rx, ry, rz;  ///< X_ji, the other end's vector to this one; empty unless twoFrames (then X_ji =
                         ///< -X_ij)
  BondReals weight;      ///< w_ij, symmetric; 0: no bond or broken
  bool vectors = true;   ///< x, y, z and weight are stored. Else a bond is its other end, and an entry whose
                         ///< end is the solid itself is unused
  bool twoFrames = false;  ///< rx, ry, rz are stored
  bool broken = false;     ///< a bond broke on this rank since the last bond update; the next update drops it

  std::size_t at(std::size_t solidIndex, int k) const {
    return (solidIndex / lanes * static_cast<std::size_t>(capacity) + static_cast<std::size_t>(k)) * lanes +
           solidIndex % lanes;
  }
  /// Returns true if this entry of an owned solid holds a bond.
  bool hasBond(std::size_t solidIndex, int k) const {
    return vectors ? weight[at(solidIndex, k)] > 0 : neighbour[at(solidIndex, k)] != solidIndex;
  }
  /// Breaks a bond: sums skip it from now on, and the next bond update drops it.
  void cut(std::size_t solidIndex, int k) {
    if (vectors) weight.set(at(solidIndex, k), 0);
    else neighbour[at(solidIndex, k)] = static_cast<std::uint32_t>(solidIndex);
    broken = true;
  }
  /// Calls use(array) for the stored arrays of reals.
  template<class Use> void eachReal(Use&& use) {
    if (!vectors) return;
    for (BondReals* r : {&x, &y, &z, &weight}) use(*r);
    if (twoFrames)
      for (BondReals* r : {&rx, &ry, &rz}) use(*r);
  }
  std::size_t bytes() const {
    std::size_t n = neighbour.capacity() * sizeof(std::uint32_t);
    for (const BondReals* r : {&x, &y, &z, &rx, &ry, &rz, &weight}) n += r->bytes();
    return n;
  }
  /// Chooses the storage that the scene needs: vectors per bond, vectors of both ends, and precision. Call it
  /// before the first bond is made.
  void choose(bool ownVectors, bool ofBothEnds, bool single) {
    vectors = ownVectors;
    twoFrames = ofBothEnds;
    for (BondReals* r : {&x, &y, &z, &rx, &ry, &rz, &weight}) r->single = single;
  }
  /// Removes all bonds and frees the memory. The choice of storage stays.
  void clear() {
    Bonds none;
    none.choose(vectors, twoFrames, x.single);
    *this = std::move(none);
  }
};

}  // namespace thaw
