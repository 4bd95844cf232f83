// SPDX-License-Identifier: Apache-2.0
// Surface tension from a surface energy (surface_energy.hpp): gradient and colour of a particle, and forces.
// Terms of the pair sums (term.hpp).
#pragma once
#include "core/fluid/laws/surface_kernel.hpp"
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// h sum V grad W and sum V W over the neighbours.
template<class Real> struct SurfaceColour {
  using L = Lanes<Real>;
  const Record<Real>* positionVolume;
  const PairSums* in;
  using Data = Lanes4<Real>;
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0), colour = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const { return loadListed(positionVolume, entries); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.a, j.a), dy = positionDifference(i.b, j.b),
            dz = positionDifference(i.c, j.c);
    const L q2 = dx * dx + dy * dy + dz * dz, g = j.d * SurfaceKernel::slope(q2);
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
    s.colour += j.d * SurfaceKernel::w(q2);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        in->surfaceGradient[rows[l]] = {static_cast<double>(s.x[l]), static_cast<double>(s.y[l]),
                                        static_cast<double>(s.z[l])};
        in->surfaceColour[rows[l]] = static_cast<double>(s.colour[l]);
      }
  }
};

/// -V_i sum V_j (H (u_i - u_j) + (s_i + s_j) grad W). H is the Hessian of W. u and s are the derivatives of
/// the energy by gradient and colour. For j, every factor is equal or of opposite sign, bit by bit. The sum
/// is in double precision, so no momentum is lost to rounding.
template<class Real> struct SurfaceForces {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *surfaceEnergyDerivatives;
  const PairSums* in;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, surfaceEnergyDerivatives;
  };
  using Wide = Lanes<double>;
  struct Sum {
    Wide x = Wide(0.0), y = Wide(0.0), z = Wide(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(surfaceEnergyDerivatives, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q2 = dx * dx + dy * dy + dz * dz, VV = i.positionVolume.d * j.positionVolume.d;
    // grad W = slope d, H = slope 1 + bend d d
    const L slope = SurfaceKernel::slope(q2), bend = SurfaceKernel::secondDerivative(q2);
    const L x = i.surfaceEnergyDerivatives.a - j.surfaceEnergyDerivatives.a,
            y = i.surfaceEnergyDerivatives.b - j.surfaceEnergyDerivatives.b,
            z = i.surfaceEnergyDerivatives.c - j.surfaceEnergyDerivatives.c;
    const L along = bend * (x * dx + y * dy + z * dz) +
                    slope * (i.surfaceEnergyDerivatives.d + j.surfaceEnergyDerivatives.d);
    s.x -= widen(VV * (slope * x + along * dx));
    s.y -= widen(VV * (slope * y + along * dy));
    s.z -= widen(VV * (slope * z + along * dz));
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
