// SPDX-License-Identifier: Apache-2.0
// The viscous forces of forces.hpp as a linear operator on a velocity, for the implicit solver. One term of
// the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/pair_viscosity.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/kernels/viscous_weight.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Extracts eight viscosities and liquid fractions from the last value of a ViscousRecord: two floats in the
/// space of a double.
THAW_INLINE void splitFloats(LanesD both, LanesF& first, LanesF& second) {
  const Vec8f lo = reinterpret_cast<Vec8f>(both.lo), hi = reinterpret_cast<Vec8f>(both.hi);
  first = LanesF(__builtin_shufflevector(lo, hi, 0, 2, 4, 6, 8, 10, 12, 14));
  second = LanesF(__builtin_shufflevector(lo, hi, 1, 3, 5, 7, 9, 11, 13, 15));
}
template<class Real> struct Widened;
template<> struct Widened<float> {
  static THAW_INLINE LanesF of(LanesF a) { return a; }
};
template<> struct Widened<double> {
  static THAW_INLINE LanesD of(LanesF a) { return widen(a); }
};

/// sum_j c_ij (u_ij . x_ij) x_ij: minus the pairwise viscous force of forces.hpp. The factor c_ij and the
/// position difference have the precision of the scene and, up to sign, the same bits at both ends.
/// Velocities and sums are always in double precision. The operator is thus symmetric, and momentum is
/// conserved to double rounding. A tiny u_ij is resolved next to a large u. Start also sums the particle's
/// own 3x3 block; Force also sums the dissipation at `middle`.
template<class Real, ViscousPass pass> struct ViscousOperator {
  using L = Lanes<Real>;
  static constexpr bool blocks = pass == ViscousPass::Start, lost = pass == ViscousPass::Force;
  const Record<Real>* positionVolume;
  const Record<double>*velocity, *middle;
  const ViscousSums* out;
  double scale;
  L weight;  ///< weight of viscosity (viscous_weight.hpp)
  struct Data {
    Lanes4<Real> positionVolume;
    Lanes4<double> velocity, middle;
    LanesF viscosity, liquid;
  };
  struct Sum {
    LanesD x = LanesD(0.0), y = LanesD(0.0), z = LanesD(0.0), lost = LanesD(0.0);
    L xx = L(0.0), yy = L(0.0), zz = L(0.0), xy = L(0.0), yz = L(0.0), xz = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    d.velocity = loadListed(velocity, entries);
    if constexpr (lost) d.middle = loadListed(middle, entries);
    splitFloats(d.velocity.d, d.viscosity, d.liquid);
    return d;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q2 = dx * dx + dy * dy + dz * dz;
    const LanesF viscosity = pairViscosity(i.viscosity, j.viscosity, i.liquid, j.liquid);
    const L c = i.positionVolume.d * j.positionVolume.d * Widened<Real>::of(viscosity) *
                alongPair(weight, q2) / (q2 + L(1e-6));
    const LanesD ex = widen(dx), ey = widen(dy), ez = widen(dz);
    const LanesD approach = (i.velocity.a - j.velocity.a) * ex + (i.velocity.b - j.velocity.b) * ey +
                            (i.velocity.c - j.velocity.c) * ez;
    const LanesD f = widen(c) * approach;
    s.x += f * ex;
    s.y += f * ey;
    s.z += f * ez;
    if constexpr (blocks) {
      const L cx = c * dx, cy = c * dy;
      s.xx += cx * dx;
      s.yy += cy * dy;
      s.zz += c * dz * dz;
      s.xy += cx * dy;
      s.yz += cy * dz;
      s.xz += cx * dz;
    }
    if constexpr (lost)
      s.lost += f * ((i.middle.a - j.middle.a) * ex + (i.middle.b - j.middle.b) * ey +
                     (i.middle.c - j.middle.c) * ez);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const std::uint32_t i = rows[l];
        out->result[i] = {scale * s.x[l], scale * s.y[l], scale * s.z[l]};
        if constexpr (blocks)
          out->block[i] = {scale * static_cast<double>(s.xx[l]), scale * static_cast<double>(s.yy[l]),
                           scale * static_cast<double>(s.zz[l]), scale * static_cast<double>(s.xy[l]),
                           scale * static_cast<double>(s.yz[l]), scale * static_cast<double>(s.xz[l])};
        if constexpr (lost) out->lost[i] += 0.5 * scale * s.lost[l];
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
