// SPDX-License-Identifier: Apache-2.0
// Pressure, viscosity, heat and artificial viscosity of one liquid with constant parameters: two records per
// neighbour instead of three, and no pair means. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"
#include "core/kernels/viscous_weight.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Where all particles are liquid of one material (Modules::uniform), equals Forces (forces.hpp) with
/// pairwise viscosity bit by bit, and Artificial (artificial_viscosity.hpp) to rounding.
/// velocityViscosity.d is the pressure term. With heat it is the temperature, which identifies the dummy row,
/// and positionVolume.d is the pressure term, since all particles have the same volume.
/// Carried: positionVolume.d, velocityViscosity.d and tensor hold the pressure tensor (forces.hpp);
/// velocityViscosity.d identifies the dummy row.
template<class Real, class Kernel, bool Heat, bool Shocks, bool Carried = false> struct UniformForces {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *tensor;
  const PairSums* in;
  L pressureScale, viscousScale, viscousWeight, viscosity, conductivity, artificial, volume;
  double heatScale, artificialScale;
  static constexpr double unit = lengthUnit<Real>;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, tensor;
    THAW_INLINE L pressure() const { return Heat ? positionVolume.d : velocityViscosity.d; }
  };
  using Wide = Lanes<double>;
  struct Sum {
    Wide x = Wide(0.0), y = Wide(0.0), z = Wide(0.0), heat = Wide(0.0);
    L lost = L(0.0), sx = L(0.0), sy = L(0.0), sz = L(0.0), shocked = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    d.velocityViscosity = loadListed(velocityViscosity, entries);
    if constexpr (Carried) d.tensor = loadListed(tensor, entries);
    return d;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    // Positions are in lengthUnit; viscousScale and finish contain the remaining factors.
    const L dx = unitDifference(i.positionVolume.a, j.positionVolume.a),
            dy = unitDifference(i.positionVolume.b, j.positionVolume.b),
            dz = unitDifference(i.positionVolume.c, j.positionVolume.c);
    const L r2 = dot3(dx, dy, dz, dx, dy, dz), q = L(unit) * sqrt(r2), q2 = L(unit * unit) * r2;
    const L Vi = Heat || Carried ? volume : i.positionVolume.d;
    L Vj = j.positionVolume.d;
    if constexpr (Heat || Carried)
      Vj = select(j.velocityViscosity.d > L(0.5 * (Heat ? dummyTemperature : dummyPressure)), volume, L(0.0));
    const L VV = Vi * Vj;
    const L slope = Kernel::slope(q, q2);
    const L strength = pressureScale * VV * slope;
    const L ux = i.velocityViscosity.a - j.velocityViscosity.a,
            uy = i.velocityViscosity.b - j.velocityViscosity.b,
            uz = i.velocityViscosity.c - j.velocityViscosity.c;
    const L approach = dot3(ux, uy, uz, dx, dy, dz);
    const L mu = viscosity * VV * weightAt(viscousWeight, q) * approach / (r2 + L(1e-6 / (unit * unit)));
    if constexpr (Carried) {
      const L xx = i.positionVolume.d + j.positionVolume.d,
              yy = i.velocityViscosity.d + j.velocityViscosity.d, zz = i.tensor.a + j.tensor.a;
      const L xy = i.tensor.b + j.tensor.b, xz = i.tensor.c + j.tensor.c, yz = i.tensor.d + j.tensor.d,
              resist = viscousScale * mu;
      s.x -= wide(strength * dot3(xx, xy, xz, dx, dy, dz) + resist * dx);
      s.y -= wide(strength * dot3(xy, yy, yz, dx, dy, dz) + resist * dy);
      s.z -= wide(strength * dot3(xz, yz, zz, dx, dy, dz) + resist * dz);
    } else {
      const L f = fma(viscousScale, mu, strength * (i.pressure() + j.pressure()));
      s.x -= wide(f * dx);
      s.y -= wide(f * dy);
      s.z -= wide(f * dz);
    }
    s.lost = fma(mu, approach, s.lost);
    if constexpr (Heat)
      s.heat += wide(VV * conductivity * Kernel::laplace(q, q2) *
                     (j.velocityViscosity.d - i.velocityViscosity.d));
    if constexpr (Shocks) {
      const L closing = min(approach, L(0.0)),
              nu = artificial * Vj * slope * closing / (r2 + L(0.01 / (unit * unit)));
      s.sx += nu * dx;
      s.sy += nu * dy;
      s.sz += nu * dz;
      s.shocked -= nu * closing;
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {  // the first sum of a step: assigned, so that nothing needs clearing
        Vec3d f{unit * s.x[l], unit * s.y[l], unit * s.z[l]};
        double dissipation = 0.5 * in->support * static_cast<double>(s.lost[l]);
        if constexpr (Heat) in->heatFlow[rows[l]] = heatScale * s.heat[l];
        if constexpr (Shocks) {
          const double v = artificialScale *
                           static_cast<double>(Heat || Carried ? volume[l] : i.positionVolume.d[l]);
          f.x += v * static_cast<double>(s.sx[l]);
          f.y += v * static_cast<double>(s.sy[l]);
          f.z += v * static_cast<double>(s.sz[l]);
          dissipation += 0.5 * v * static_cast<double>(s.shocked[l]);
        }
        in->force[rows[l]] = f;
        in->dissipation[rows[l]] = dissipation;
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
