// SPDX-License-Identifier: Apache-2.0
// Detection of touching solids. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Lists the pairs of solid particles within the contact distance. Such pairs are rare, so scalar code
/// processes the list. The phase is checked only for close pairs.
template<class Real> struct Close {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *surface;
  ClosePairs* pairs;
  L limit2;
  struct Data {
    Lanes4<Real> positionVolume;
    const std::uint32_t* entries;
  };
  struct Sum {};
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), entries};
  }
  THAW_INLINE bool solid(std::uint32_t entry) const { return ByEntry::of(surface, entry)->b > 0; }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t* at, Sum&) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const auto m = dx * dx + dy * dy + dz * dz < limit2;
    if (any(m))
      for (int l = 0; l < 8; l++)
        if (laneOf(m, l) && solid(i.entries[l]) && solid(at[l]))
          ClosePairs::append(*pairs, i.entries[l] / 2, at[l] / 2);
  }
  THAW_INLINE void finish(const std::uint32_t*, const Data&, const Sum&, std::uint32_t) const {}
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
