// SPDX-License-Identifier: Apache-2.0
// XSPH velocity correction. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// XSPH (M89): mean velocity of the surrounding flow minus the particle's velocity, times epsilon.
template<class Real, class Kernel> struct Smoothing {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *surface;
  const PairSums* in;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, surface;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries),
            loadListed(surface, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L w = min(i.surface.d, j.surface.d) * j.positionVolume.d * Kernel::w(dx * dx + dy * dy + dz * dz);
    s.x -= w * (i.velocityViscosity.a - j.velocityViscosity.a);
    s.y -= w * (i.velocityViscosity.b - j.velocityViscosity.b);
    s.z -= w * (i.velocityViscosity.c - j.velocityViscosity.c);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const Vec3d found{static_cast<double>(s.x[l]), static_cast<double>(s.y[l]),
                          static_cast<double>(s.z[l])};
        Vec3d& smoothed = in->smoothed[rows[l]];
        smoothed = in->concentrationGradient ? smoothed + found : found;  // add to the shifting velocity
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
