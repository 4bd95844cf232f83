// SPDX-License-Identifier: Apache-2.0
// Free-surface indicator. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Free-surface indicator of a particle: |grad c| times a length. The length is such that the indicators of a
/// column of particles below a flat surface sum to 1.
template<class Real, class Kernel> struct FreeSurfaceIndicator {
  using L = Lanes<Real>;
  const Record<Real>* positionVolume;
  const PairSums* in;
  using Data = Lanes4<Real>;
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const { return loadListed(positionVolume, entries); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.a, j.a), dy = positionDifference(i.b, j.b),
            dz = positionDifference(i.c, j.c);
    const L g = j.d * Kernel::slope(dx * dx + dy * dy + dz * dz);
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const L size = sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy)
        in->freeSurfaceIndicator[rows[l]] = static_cast<float>(static_cast<double>(size[l]) *
                                                               in->freeSurfaceIndicatorScale / in->support);
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
