// SPDX-License-Identifier: Apache-2.0
// Artificial viscosity. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Artificial viscosity (M92) of approaching pairs. The record is alpha c h rho / 10 (Pa s). Between liquids
/// with tension the pair's value is the arithmetic mean, since free-surface damping acts on pairs across the
/// interface (LiquidMaterial::surfaceDamping).
template<class Real, class Kernel> struct Artificial {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *surface;
  const PairSums* in;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, surface;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0), lost = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries),
            loadListed(surface, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q2 = dx * dx + dy * dy + dz * dz;
    const L approach = min((i.velocityViscosity.a - j.velocityViscosity.a) * dx +
                               (i.velocityViscosity.b - j.velocityViscosity.b) * dy +
                               (i.velocityViscosity.c - j.velocityViscosity.c) * dz,
                           L(0.0));
    const L both = i.surface.c + j.surface.c,
            mean = select(i.surface.a * j.surface.a > L(0.0), L(0.5) * both,
                          L(2.0) * i.surface.c * j.surface.c / max(both, L(1e-30)));
    const L mu = mean * j.positionVolume.d * Kernel::slope(q2) * approach / (q2 + L(0.01));
    s.x += mu * dx;
    s.y += mu * dy;
    s.z += mu * dz;
    s.lost -= mu * approach;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double v = scale * static_cast<double>(i.positionVolume.d[l]);
        Vec3d& f = in->force[rows[l]];
        f.x += v * static_cast<double>(s.x[l]);
        f.y += v * static_cast<double>(s.y[l]);
        f.z += v * static_cast<double>(s.z[l]);
        in->dissipation[rows[l]] += 0.5 * v * static_cast<double>(s.lost[l]);
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
