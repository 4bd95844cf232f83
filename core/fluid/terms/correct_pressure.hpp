// What corrected gradients add to the pressure. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Force of the corrected gradient beyond that of Forces: V_i V_j (D_i + D_j) grad W with D = pressure term (L - 1), L the inverse of the
/// neighbourhood's moment (Bonet & Lok 1999): the adjoint of the corrected divergence, so pairs keep momentum and energy; not central.
template<class Real, class Kernel> struct CorrectPressure {
  using L = Lanes<Real>;
  const Record<Real>*place, *diagonal, *mixed;
  const PairSums* in;
  double scale;
  struct Data { Lanes4<Real> place, diagonal, mixed; };
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(place, entries), loadListed(diagonal, entries), loadListed(mixed, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L g = j.place.d * Kernel::slope(dx * dx + dy * dy + dz * dz);
    const L xx = i.diagonal.a + j.diagonal.a, yy = i.diagonal.b + j.diagonal.b, zz = i.diagonal.c + j.diagonal.c;
    const L xy = i.mixed.a + j.mixed.a, xz = i.mixed.b + j.mixed.b, yz = i.mixed.c + j.mixed.c;
    s.x -= g * (xx * dx + xy * dy + xz * dz);
    s.y -= g * (xy * dx + yy * dy + yz * dz);
    s.z -= g * (xz * dx + yz * dy + zz * dz);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double p = static_cast<double>(i.place.d[l]) * scale;
        Vec3d& f = in->force[rows[l]];
        f.x += p * static_cast<double>(s.x[l]);
        f.y += p * static_cast<double>(s.y[l]);
        f.z += p * static_cast<double>(s.z[l]);
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
