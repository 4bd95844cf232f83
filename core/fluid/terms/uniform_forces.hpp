// SPDX-License-Identifier: Apache-2.0
// Pressure, viscosity, heat and artificial viscosity of one liquid with constant parameters: two records per
// neighbour instead of three, and no pair means. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/lane_vectors.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/kernels/viscous_weight.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Forces for particles that are all liquid of one material (Modules::uniform). They equal Forces
/// (forces.hpp) with pairwise viscosity bit by bit, and Artificial (artificial_viscosity.hpp) to rounding.
/// velocityViscosity.d is the pressure term. With heat it is the temperature, which identifies the dummy row.
/// Then positionVolume.d is the pressure term, since all particles have the same volume.
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
  /// A neighbour before its sums. Positions are in lengthUnit; viscousScale and finish contain the remaining
  /// factors.
  struct Pair {
    Vector3<L> d;  ///< own - other
    L r2, q, VV, Vj;
    L approach;          ///< u . d
    Vector3<L> tension;  ///< Carried: sum of both pressure tensors times d
    L pressure;          ///< else: sum of both pressure terms
    L warmth;            ///< Heat: other - own temperature
  };
  THAW_INLINE Pair begin(const Data& i, const Data& j) const {
    Pair p;
    p.d = {unitDifference(i.positionVolume.a, j.positionVolume.a),
           unitDifference(i.positionVolume.b, j.positionVolume.b),
           unitDifference(i.positionVolume.c, j.positionVolume.c)};
    p.r2 = dotOf(p.d, p.d);
    p.q = L(unit) * sqrt(p.r2);
    p.Vj = j.positionVolume.d;
    if constexpr (Heat || Carried)
      p.Vj = select(j.velocityViscosity.d > L(0.5 * (Heat ? dummyTemperature : dummyPressure)), volume,
                    L(0.0));
    p.VV = (Heat || Carried ? volume : i.positionVolume.d) * p.Vj;
    const Vector3<L> u{i.velocityViscosity.a - j.velocityViscosity.a,
                       i.velocityViscosity.b - j.velocityViscosity.b,
                       i.velocityViscosity.c - j.velocityViscosity.c};
    p.approach = dotOf(u, p.d);
    if constexpr (Carried) {
      const L xx = i.positionVolume.d + j.positionVolume.d,
              yy = i.velocityViscosity.d + j.velocityViscosity.d, zz = i.tensor.a + j.tensor.a,
              xy = i.tensor.b + j.tensor.b, xz = i.tensor.c + j.tensor.c, yz = i.tensor.d + j.tensor.d;
      p.tension = {dotOf({xx, xy, xz}, p.d), dotOf({xy, yy, yz}, p.d), dotOf({xz, yz, zz}, p.d)};
    } else {
      p.pressure = i.pressure() + j.pressure();
    }
    if constexpr (Heat) p.warmth = j.velocityViscosity.d - i.velocityViscosity.d;
    return p;
  }
  THAW_INLINE void add(const Data&, const Pair& p, Sum& s) const {
    const L q2 = L(unit * unit) * p.r2, slope = Kernel::slope(p.q, q2);
    const L strength = pressureScale * p.VV * slope;
    const L mu = viscosity * p.VV * weightAt(viscousWeight, p.q) * p.approach /
                 (p.r2 + L(1e-6 / (unit * unit)));
    if constexpr (Carried) {
      const L resist = viscousScale * mu;
      s.x -= wide(fma(resist, p.d.x, strength * p.tension.x));
      s.y -= wide(fma(resist, p.d.y, strength * p.tension.y));
      s.z -= wide(fma(resist, p.d.z, strength * p.tension.z));
    } else {
      const L f = fma(viscousScale, mu, strength * p.pressure);
      s.x -= wide(f * p.d.x);
      s.y -= wide(f * p.d.y);
      s.z -= wide(f * p.d.z);
    }
    s.lost = fma(mu, p.approach, s.lost);
    if constexpr (Heat) s.heat += wide(p.VV * conductivity * Kernel::laplace(p.q, q2) * p.warmth);
    if constexpr (Shocks) {
      const L closing = min(p.approach, L(0.0)),
              nu = artificial * p.Vj * slope * closing / (p.r2 + L(0.01 / (unit * unit)));
      s.sx += nu * p.d.x;
      s.sy += nu * p.d.y;
      s.sz += nu * p.d.z;
      s.shocked -= nu * closing;
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {  // the first sum of a step is assigned, so that nothing needs to be cleared
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
