// SPDX-License-Identifier: Apache-2.0
// Pressure, viscosity and heat conduction of liquids. One term of the pair sums (term.hpp). One liquid:
// uniform_forces.hpp. Incompressible: incompressible.hpp. Walls: core/walls/.
#pragma once
#include "core/fluid/terms/pair_viscosity.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/kernels/viscous_weight.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

THAW_INLINE MaskF hasMinus(LanesF a) { return {reinterpret_cast<Vec8i>(a.v) < 0}; }
THAW_INLINE MaskD hasMinus(LanesD a) {
  return {reinterpret_cast<Vec4l>(a.lo) < 0, reinterpret_cast<Vec4l>(a.hi) < 0};
}
/// Returns the solid fraction, 0 for fixed solids.
template<class L> THAW_INLINE L movableSolid(L liquidFraction) {
  return select(hasMinus(liquidFraction), L(0.0), L(1.0) - liquidFraction);
}

/// Pressure: F_i = -1/S sum V_i V_j (p_i / d_i^2 + p_j / d_j^2) grad W (variational, M05 eq. 3.3), or as
/// printed in K05. Here d are relative densities, and S is the lattice sum (docs/theory/pressure.md).
/// Viscosity: Monaghan's pair form along r (M05 eq. 8.9 without its artificial scaling), or MCG03 eq. 13
/// (docs/theory/viscosity.md). Without Viscous it is implicit (viscous_operator.hpp). Heat conduction: CM99
/// eq. 36. Fields of the records: docs/developer/extend.md.
/// A solid particle responds with the pressure of its liquid neighbour (A12). The force is the gradient of
/// the liquid's compression energy, so the pair conserves energy. It also has viscous drag. Two solids do not
/// interact.
/// Carried: pressure is a tensor, p / (relative density)^2 times the gradient correction, the inverse moment
/// (BL99). The force is the adjoint of the corrected divergence, so pairs conserve momentum and energy. It is
/// not central. The pressure of a solid near liquid acts only between that solid and liquids.
/// Relief: pressureDiagonal.d, pressureOffDiagonal.d and pressurePhaseHeat.a are the force on liquid from all
/// its solid neighbours (core/fluid/laws/lattice_relief.hpp). It is divided among the pairs by V W of the
/// solids. Fixed solids, which have a liquid fraction of -0, have no such force. They need not slip, and the
/// force would stir liquid at rest.
template<class Real, class Kernel, bool Viscous, bool Laplacian, bool Heat, bool Carried = false,
         bool Relief = false>
struct Forces {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat, *pressureDiagonal,
      *pressureOffDiagonal;
  const PairSums* in;
  L pressureScale, viscousScale, viscousWeight;  ///< viscousScale: per lengthUnit
  double heatScale;
  L reliefScale, reliefPower;  ///< reliefScale: normalises lattice sums of W to 1, divided by lengthUnit;
                               ///< reliefPower: 1/m, lengthUnit over the support
  static constexpr double unit = lengthUnit<Real>;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat, pressureDiagonal, pressureOffDiagonal;
  };
  using Wide = Lanes<double>;  ///< sums are in double precision for both types of records
  struct Sum {
    Wide x = Wide(0.0), y = Wide(0.0), z = Wide(0.0);
    L dissipated = L(0.0);
    Wide heat = Lanes<double>(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    d.velocityViscosity = loadListed(velocityViscosity, entries);
    d.pressurePhaseHeat = loadListed(pressurePhaseHeat, entries);
    if constexpr (Carried)
      d.pressureDiagonal = loadListed(pressureDiagonal, entries),
      d.pressureOffDiagonal = loadListed(pressureOffDiagonal, entries);
    return d;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    // Positions are in lengthUnit; viscousScale and finish contain the remaining factors.
    const L dx = unitDifference(i.positionVolume.a, j.positionVolume.a),
            dy = unitDifference(i.positionVolume.b, j.positionVolume.b),
            dz = unitDifference(i.positionVolume.c, j.positionVolume.c);
    const L r2 = dot3(dx, dy, dz, dx, dy, dz), q = L(unit) * sqrt(r2), q2 = L(unit * unit) * r2;
    const L VV = i.positionVolume.d * j.positionVolume.d;
    const L slope = Kernel::slope(q, q2);
    const L fi = i.pressurePhaseHeat.b, fj = j.pressurePhaseHeat.b;
    // For j, every factor below is equal or of opposite sign, bit by bit. Sums in double precision thus
    // conserve momentum.
    const L strength = pressureScale * VV * slope,
            pressure = Carried ? L(0.0) : strength * (i.pressurePhaseHeat.a + j.pressurePhaseHeat.a);
    const L ux = i.velocityViscosity.a - j.velocityViscosity.a,
            uy = i.velocityViscosity.b - j.velocityViscosity.b,
            uz = i.velocityViscosity.c - j.velocityViscosity.c;
    const L pairLiquidFraction = fi + fj - fi * fj;
    if constexpr (Carried) {
      const L xx = i.pressureDiagonal.a + j.pressureDiagonal.a,
              yy = i.pressureDiagonal.b + j.pressureDiagonal.b,
              zz = i.pressureDiagonal.c + j.pressureDiagonal.c;
      const L xy = i.pressureOffDiagonal.a + j.pressureOffDiagonal.a,
              xz = i.pressureOffDiagonal.b + j.pressureOffDiagonal.b,
              yz = i.pressureOffDiagonal.c + j.pressureOffDiagonal.c, k = strength * pairLiquidFraction;
      s.x -= wide(k * dot3(xx, xy, xz, dx, dy, dz));
      s.y -= wide(k * dot3(xy, yy, yz, dx, dy, dz));
      s.z -= wide(k * dot3(xz, yz, zz, dx, dy, dz));
    }
    if constexpr (Relief) {
      const L w = reliefScale * Kernel::w(q, q2), shareOfI = w * movableSolid(fj) * j.positionVolume.d,
              shareOfJ = w * movableSolid(fi) * i.positionVolume.d;
      const L fx = shareOfI * i.pressureDiagonal.d - shareOfJ * j.pressureDiagonal.d,
              fy = shareOfI * i.pressureOffDiagonal.d - shareOfJ * j.pressureOffDiagonal.d,
              fz = shareOfI * i.pressurePhaseHeat.a - shareOfJ * j.pressurePhaseHeat.a;
      s.x += wide(fx);
      s.y += wide(fy);
      s.z += wide(fz);
      s.dissipated -= reliefPower * (fx * ux + fy * uy + fz * uz);
    }
    const L mui = i.velocityViscosity.d, muj = j.velocityViscosity.d;
    if constexpr (!Viscous) {
      if constexpr (!Carried) {
        s.x -= wide(pressure * dx);
        s.y -= wide(pressure * dy);
        s.z -= wide(pressure * dz);
      }
    } else if constexpr (Laplacian) {
      const L mu = L(0.5) * (mui + muj) * pairLiquidFraction * VV * Kernel::laplace(q, q2),
              m = viscousScale * mu;
      s.x -= wide(pressure * dx + m * ux);
      s.y -= wide(pressure * dy + m * uy);
      s.z -= wide(pressure * dz + m * uz);
      s.dissipated += mu * (ux * ux + uy * uy + uz * uz);
    } else {
      const L approach = dot3(ux, uy, uz, dx, dy, dz);
      const L mu = pairViscosity(mui, muj, fi, fj) * VV * weightAt(viscousWeight, q) * approach /
                   (r2 + L(1e-6 / (unit * unit)));
      const L f = fma(viscousScale, mu, pressure);
      s.x -= wide(f * dx);
      s.y -= wide(f * dy);
      s.z -= wide(f * dz);
      s.dissipated = fma(mu, approach, s.dissipated);
    }
    if constexpr (Heat) {
      // The sum is in double precision, so that no heat is lost to rounding.
      s.heat += wide(conducted(VV, i.pressurePhaseHeat, j.pressurePhaseHeat, Kernel::laplace(q, q2)));
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        Vec3d& f = in->force[rows[l]];
        f.x += unit * s.x[l];
        f.y += unit * s.y[l];
        f.z += unit * s.z[l];
        in->dissipation[rows[l]] += 0.5 * in->support * static_cast<double>(s.dissipated[l]);
        if constexpr (Heat) in->heatFlow[rows[l]] += heatScale * s.heat[l];
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
