// SPDX-License-Identifier: Apache-2.0
// Surface tension by K05's colour field. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Colour-field surface tension as printed in K05 / MCG03: -k lap(c) n / |n| where |n| exceeds a threshold.
/// It violates Laplace's law under refinement (docs/theory/surface_tension.md), so it is only an explicit
/// option.
template<class Real> struct ColourField {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *surface, *pressurePhaseHeat;
  const PairSums* in;
  struct Data {
    Lanes4<Real> positionVolume, surface, pressurePhaseHeat;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0), laplacian = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(surface, entries),
            loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q2 = dx * dx + dy * dy + dz * dz, u = max(L(1.0) - q2, L(0.0));
    const L c = L(-945 / (32 * pi)) * j.positionVolume.d * u;  // derivative of poly6
    s.x += c * u * dx;
    s.y += c * u * dy;
    s.z += c * u * dz;
    s.laplacian += c * (L(3.0) - L(7.0) * q2);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double h = in->support, V = static_cast<double>(i.positionVolume.d[l]) * h * h * h,
                     root = static_cast<double>(i.surface.a[l]);
        const Vec3d n{static_cast<double>(s.x[l]), static_cast<double>(s.y[l]), static_cast<double>(s.z[l])};
        const double size = __builtin_sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        if (size < 0.3) continue;  // |n| h: noise inside the liquid (docs/validation/stability.md, row 24)
        const double laplacian = static_cast<double>(s.laplacian[l]) -
                                 945 / (32 * pi) * 3 * static_cast<double>(i.positionVolume.d[l]);
        const double k = -root * root * laplacian / (h * h) * V / size;
        Vec3d& f = in->force[rows[l]];
        f.x += k * n.x;
        f.y += k * n.y;
        f.z += k * n.z;
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
