// SPDX-License-Identifier: Apache-2.0
// Density. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Relative density: delta_i = sum_j V0_j W_ij / (value of the sum on the lattice), self included, minus
/// PairSums::selfExcess. It is 1 on the lattice and grows under compression like the density. The term
/// selfExcess is a correction as in DA12 eq. 18. Without it, the slope at h = 2 dx would be 0.95 of the
/// density's, on bcc and fcc lattices as well.
template<class Real, class Kernel> struct Density {
  using L = Lanes<Real>;
  const Record<Real>* positionVolume;
  float* relativeDensity;
  std::int64_t* coincident;
  double scale, selfExcess;
  using Data = Lanes4<Real>;
  static constexpr double unit = lengthUnit<Real>;
  /// closest: r^2 of the closest neighbour, in unit^2.
  struct Sum {
    L relativeDensity = L(0.0), closest = L(1 / (unit * unit));
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const { return loadListed(positionVolume, entries); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = unitDifference(i.a, j.a), dy = unitDifference(i.b, j.b), dz = unitDifference(i.c, j.c),
            r2 = dot3(dx, dy, dz, dx, dy, dz);
    s.relativeDensity = fma(j.d, Kernel::w(L(unit) * sqrt(r2), L(unit * unit) * r2), s.relativeDensity);
    s.closest = select(j.d > L(0.0), min(s.closest, r2), s.closest);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L total = s.relativeDensity + i.d * Kernel::w(L(0.0));
    const L touch(1e-20 / (unit * unit));
    const bool touching = any(s.closest < touch);
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        relativeDensity[rows[l]] = static_cast<float>(scale * static_cast<double>(total[l]) -
                                                      selfExcess * static_cast<double>(i.d[l]));
        if (touching && s.closest[l] < touch[l]) ++*coincident;
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
