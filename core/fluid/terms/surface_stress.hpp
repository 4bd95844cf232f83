// Surface tension as a stress along the surface: the surface's normal and moment, and the forces. Terms of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Kernel of the stress, slope = w'(q) / q: its pull grows with the distance up to .6 h, beyond next neighbours, so that a layer under
/// tension does not clump (a stress is stable where it and w'' are of different sign, Swegle et al. 1995).
struct StressKernel {
  template<class T> static THAW_INLINE T slope(T q2) {
    const T u = max(T(1.0) - sqrt(q2), T(0.0));
    return T(-189 / pi) * (q2 * (u * u));
  }
};

/// h sum V grad W with the scene's kernel, and the moment -sum V grad W x with the kernel of the stress.
template<class Real, class Kernel> struct ColourGradient {
  using L = Lanes<Real>;
  const Record<Real>* place;
  const PairSums* in;
  using Data = Lanes4<Real>;
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0), xx = L(0.0), yy = L(0.0), zz = L(0.0), xy = L(0.0), yz = L(0.0), xz = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const { return thaw::THAW_ISA::load(place, rows); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.a, j.a), dy = positionDifference(i.b, j.b), dz = positionDifference(i.c, j.c);
    const L q2 = dx * dx + dy * dy + dz * dz, g = j.d * Kernel::slope(q2), m = j.d * StressKernel::slope(q2);
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
    const L mx = m * dx, my = m * dy, mz = m * dz;
    s.xx -= mx * dx;
    s.yy -= my * dy;
    s.zz -= mz * dz;
    s.xy -= mx * dy;
    s.yz -= my * dz;
    s.xz -= mx * dz;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const auto at = [](const L& a, int l) { return static_cast<double>(a[l]); };
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        in->colourGradient[rows[l]] = {at(s.x, l), at(s.y, l), at(s.z, l)};
        in->surfaceMoment[rows[l]] = {at(s.xx, l), at(s.yy, l), at(s.zz, l), at(s.xy, l), at(s.yz, l), at(s.xz, l)};
      }
  }
};

/// V_i sum V_j (P_i + P_j) grad W with P of Continuum::surfaceStress. Every factor is the same for j, or of the other sign, to the last bit:
/// summed in double precision, no momentum is lost to rounding.
template<class Real> struct SurfaceStress {
  using L = Lanes<Real>;
  const Record<Real>*place, *stretch, *shear;
  const PairSums* in;
  double scale;
  struct Data { Lanes4<Real> place, stretch, shear; };
  using Wide = Lanes<double>;
  struct Sum { Wide x = Wide(0.0), y = Wide(0.0), z = Wide(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const {
    return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(stretch, rows), thaw::THAW_ISA::load(shear, rows)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L g = i.place.d * j.place.d * StressKernel::slope(dx * dx + dy * dy + dz * dz);
    const L xx = i.stretch.a + j.stretch.a, yy = i.stretch.b + j.stretch.b, zz = i.stretch.c + j.stretch.c;
    const L xy = i.shear.a + j.shear.a, yz = i.shear.b + j.shear.b, xz = i.shear.c + j.shear.c;
    s.x += widen(g * (xx * dx + xy * dy + xz * dz));
    s.y += widen(g * (xy * dx + yy * dy + yz * dz));
    s.z += widen(g * (xz * dx + yz * dy + zz * dz));
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        Vec3d& f = in->force[rows[l]];
        f.x += scale * s.x[l];
        f.y += scale * s.y[l];
        f.z += scale * s.z[l];
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
