// Bonds of the owned slots. What a bond holds depends on the scene: where no reference is ever taken anew
// (nothing freezes, welds or flows far) all bonds are of one configuration, and a bond is its other end
// alone: X_ij is the difference of Solids::reference, and the weight follows from its length. Else each bond
// has its vectors and its weight, in the precision in which the elastic step works.
#pragma once
#include <algorithm>
#include <type_traits>

#include "core/particles/column.hpp"

namespace thaw {

inline constexpr int lanes = 8;  ///< bonds and neighbour lists are interleaved by groups of 8 rows (sliced
                                 ///< ELLPACK)

/// A number of each bond, single or double. Nothing else of a bond is kept in another precision beside it.
class BondReals {
 public:
  bool single = false;  ///< set while it is empty
  double operator[](std::size_t at) const { return single ? static_cast<double>(f_[at]) : d_[at]; }
  void set(std::size_t at, double value) {
    if (single) f_[at] = static_cast<float>(value);
    else d_[at] = value;
  }
  std::size_t size() const { return single ? f_.size() : d_.size(); }
  std::size_t bytes() const { return f_.capacity() * sizeof(float) + d_.capacity() * sizeof(double); }
  const void* data() const { return single ? static_cast<const void*>(f_.data()) : d_.data(); }
  /// use(vector) with the vector of this precision.
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

/// Bond k of slot s is element at(s, k) of each array. The order of a slot's bonds is part of the state: it
/// is the order of sums, the same on any number of ranks.
struct Bonds {
  int capacity = 0;                        ///< bonds a slot has room for; grows as needed
  AlignedVector<std::uint32_t> neighbour;  ///< slot of the other end; where there is no bond some row that
                                           ///< may be read, the slot itself if it is owned
  BondReals x, y, z;  ///< reference vector X_ij from this end to the other, in this end's reference frame (m)
  BondReals rx, ry, rz;  ///< the other end's own vector back to this one, X_ji; empty unless twoFrames (then
                         ///< X_ji = -X_ij)
  BondReals weight;      ///< w_ij, symmetric; 0: no bond or broken
  bool vectors = true;   ///< x, y, z and weight are kept; else a bond is its other end, and places whose end
                         ///< is the slot itself hold none
  bool twoFrames = false;  ///< rx, ry, rz are kept
  bool broken = false;     ///< some bond was cut on this rank since the last relink, which then drops it

  std::size_t at(std::size_t slot, int k) const {
    return (slot / lanes * static_cast<std::size_t>(capacity) + static_cast<std::size_t>(k)) * lanes +
           slot % lanes;
  }
  /// Is there a bond in this place of an owned slot?
  bool there(std::size_t slot, int k) const {
    return vectors ? weight[at(slot, k)] > 0 : neighbour[at(slot, k)] != slot;
  }
  /// Breaks a bond: it has no part in any sum from now on, and the next relink drops it.
  void cut(std::size_t slot, int k) {
    if (vectors) weight.set(at(slot, k), 0);
    else neighbour[at(slot, k)] = static_cast<std::uint32_t>(slot);
    broken = true;
  }
  /// Calls use(array) for the arrays of numbers that are kept.
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
  /// What the scene decides: is there a reference of each bond, of each of its ends, and in which precision?
  /// Before the first bond is made.
  void choose(bool ownVectors, bool ofBothEnds, bool single) {
    vectors = ownVectors;
    twoFrames = ofBothEnds;
    for (BondReals* r : {&x, &y, &z, &rx, &ry, &rz, &weight}) r->single = single;
  }
  /// No bonds, no memory; what the scene decides stays.
  void clear() {
    Bonds none;
    none.choose(vectors, twoFrames, x.single);
    *this = std::move(none);
  }
};

}  // namespace thaw
