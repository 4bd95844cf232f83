// SPDX-License-Identifier: Apache-2.0
// Continuity density and concentration gradient. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/carry.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

enum class Carry { Nothing, Density, Corrected };
/// Particles in a sum. One: one liquid with records of Modules::uniform. Liquids: several liquids. Solids:
/// liquids and solids that carry the density of adjacent liquid (C07).
enum class Mix { One, Liquids, Solids };

/// Summed relative density (as Density) and h times its gradient, for shifting.
/// Carry::Density: also its rate, sum V0_j (u_i - u_j).grad W. The adjoint is the pressure force of Forces,
/// so pairs conserve energy (BL99).
/// Carry::Corrected: instead the sums for the corrected rate (terms/carry.hpp).
/// Both: density diffusion (MC09 eq. 11) minus its hydrostatic part (F19 eq. 10), and the step of the carried
/// density. Positions are those at mid-step: pressure work then equals the loss of compression energy to
/// second order. Several liquids or solids: the diffusing quantity is the pressure over a common stiffness.
/// Surfaces: also the sums of the free surface.
template<class Real, class Kernel, Carry carry, bool Surfaces = false, Mix mix = Mix::Solids>
struct CarriedDensity {
  using L = Lanes<Real>;
  static constexpr double unit = lengthUnit<Real>;
  static constexpr bool Carried = carry != Carry::Nothing, Corrected = carry == Carry::Corrected,
                        Mixed = mix != Mix::One, Solids = mix == Mix::Solids;
  using Step = CarryLanes<Real, Corrected, Surfaces, Mixed>;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat;
  const PairSums* in;
  double scale;
  L weight[3];  ///< h g; not Mixed: over c^2
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat;
  };
  /// Lengths are in `unit`. Differences are other - own, so sums of an odd number of differences have the
  /// opposite sign. `finish` restores units and signs.
  struct Sum {
    L relativeDensity = L(0.0), closest = L(1.0), rate = L(0.0), spread = L(0.0), column = L(0.0),
      size = L(0.0), liquidKernelSum = L(0.0), solids = L(0.0), nearby = L(0.0), depth = L(0.0);
    Vector3<L> gradient, surface, solid;
    Tensor<L> moment, strain;
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    if constexpr (Carried) d.velocityViscosity = loadListed(velocityViscosity, entries);
    if constexpr (Carried && Mixed) d.pressurePhaseHeat = loadListed(pressurePhaseHeat, entries);
    return d;
  }
  THAW_INLINE void prefetch(const std::uint32_t* rows) const {
    if constexpr (!Carried) return;
    const CarryStep& c = *in->carry;
    prefetchRows(c.mass, rows);
    prefetchRows(c.compression, rows);
    prefetchRows(c.dissipated, rows);
    prefetchRows(c.compressionRate, rows);
    if constexpr (Surfaces) prefetchRows(c.shiftingVelocity, rows);
    if constexpr (Corrected) {
      prefetchRows(c.midCorrection, rows);
      prefetchRows(c.correction, rows);
    }
  }
  /// A neighbour before its sums. Differences are other - own.
  struct Pair {
    Vector3<L> d, u;  ///< unit, m/s
    L r2, q;
    L volume;                   ///< V; negative: one liquid, at the free surface
    L mark;                     ///< Mixed: liquid fraction; negative: at the free surface
    L compression, difference;  ///< compression of the neighbour, and difference (other - own) of the
                                ///< diffusing quantity
  };
  THAW_INLINE Pair begin(const Data& i, const Data& j) const {
    Pair p;
    // The own values do not fit into registers. As subtrahends they can be memory operands.
    p.d = {unitDifference(j.positionVolume.a, i.positionVolume.a),
           unitDifference(j.positionVolume.b, i.positionVolume.b),
           unitDifference(j.positionVolume.c, i.positionVolume.c)};
    p.volume = j.positionVolume.d;
    if constexpr (Carried) {
      p.u = {j.velocityViscosity.a - i.velocityViscosity.a, j.velocityViscosity.b - i.velocityViscosity.b,
             j.velocityViscosity.c - i.velocityViscosity.c};
      if constexpr (Mixed) {
        p.mark = j.pressurePhaseHeat.b;
        p.compression = j.pressurePhaseHeat.a;
        p.difference = j.pressurePhaseHeat.a - i.pressurePhaseHeat.a;
      } else {
        p.difference = j.velocityViscosity.d - i.velocityViscosity.d;
      }
    }
    p.r2 = dotOf(p.d, p.d);
    p.q = L(unit) * sqrt(p.r2);
    return p;
  }
  THAW_INLINE void add(const Data& i, const Pair& p, Sum& s) const {
    const L q2 = L(unit * unit) * p.r2, V = Carried && Surfaces && !Mixed ? sizeOf(p.volume) : p.volume,
            kernel = Kernel::w(p.q, q2), w = V * kernel, slope = V * Kernel::slope(p.q, q2);
    s.relativeDensity = fma(V, kernel, s.relativeDensity);
    s.closest = select(V > L(0.0), min(s.closest, p.r2), s.closest);
    const Vector3<L> g = scaled(slope, p.d);
    s.gradient.x += g.x;
    s.gradient.y += g.y;
    s.gradient.z += g.z;
    if constexpr (Surfaces) addSurface(Mixed ? p.mark : p.volume, g, s);
    if constexpr (Surfaces && !Corrected) s.size -= slope * p.q;
    if constexpr (Carried) addRate(i, p, {g, w, slope, Solids ? V * Kernel::laplace(p.q, q2) : L(0.0)}, s);
  }
  struct Weights {
    Vector3<L> g;         ///< V grad W
    L w, slope, laplace;  ///< V W, V W' / q, V times the kernel of the Laplacian
  };
  /// Adds the sums that identify the free surface and adjacent solids.
  THAW_INLINE void addSurface(L mark, const Vector3<L>& g, Sum& s) const {
    if (anyNegative(mark)) [[unlikely]]  // close to the free surface
      addScaled(s.surface, select(mark < L(0.0), L(1.0), L(0.0)), g.x, g.y, g.z);
    if constexpr (Solids) addScaled(s.solid, L(1.0) - sizeOf(mark), g.x, g.y, g.z);
  }
  THAW_INLINE void addRate(const Data& i, const Pair& p, const Weights& k, Sum& s) const {
    Vector3<L> g = k.g;
    L laplace = k.laplace;
    if constexpr (Solids) {
      const L fi = sizeOf(i.pressurePhaseHeat.b), fj = sizeOf(p.mark), pairLiquidFraction = fi + fj - fi * fj,
              liquidKernel = k.w * fj;
      s.liquidKernelSum += liquidKernel;
      s.solids += k.w - liquidKernel;
      s.nearby = fma(liquidKernel, p.compression, s.nearby);
      s.depth = fma(liquidKernel, fallOf(p.d), s.depth);
      g = scaled(pairLiquidFraction, g);
      laplace = pairLiquidFraction * laplace;
    }
    if constexpr (Corrected) addTensors(p, k.g, g, s);
    else s.rate += dotOf(g, p.u);
    if constexpr (Solids) {
      s.spread = fma(laplace, p.difference, s.spread);
      s.column = fma(laplace, fallOf(p.d), s.column);
    } else {
      s.spread = fma(k.slope, p.difference, s.spread);
    }
  }
  /// Adds to the moment with the gradient `all` over all neighbours, and to the rate of strain with the
  /// gradient g over liquid.
  THAW_INLINE void addTensors(const Pair& p, const Vector3<L>& all, const Vector3<L>& g, Sum& s) const {
    s.moment.xx = fma(all.x, p.d.x, s.moment.xx);
    s.moment.yy = fma(all.y, p.d.y, s.moment.yy);
    s.moment.zz = fma(all.z, p.d.z, s.moment.zz);
    s.moment.xy = fma(all.x, p.d.y, s.moment.xy);
    s.moment.yz = fma(all.y, p.d.z, s.moment.yz);
    s.moment.xz = fma(all.x, p.d.z, s.moment.xz);
    s.strain.xx = fma(g.x, p.u.x, s.strain.xx);
    s.strain.yy = fma(g.y, p.u.y, s.strain.yy);
    s.strain.zz = fma(g.z, p.u.z, s.strain.zz);
    s.strain.xy = fma(g.x, p.u.y, fma(g.y, p.u.x, s.strain.xy));
    s.strain.yz = fma(g.y, p.u.z, fma(g.z, p.u.y, s.strain.yz));
    s.strain.xz = fma(g.x, p.u.z, fma(g.z, p.u.x, s.strain.xz));
  }
  THAW_INLINE L fallOf(const Vector3<L>& d) const {
    return dot3(weight[0], weight[1], weight[2], d.x, d.y, d.z);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L own = Carried && Surfaces && !Mixed ? sizeOf(i.positionVolume.d) : i.positionVolume.d,
            total = L(static_cast<Real>(scale)) * (s.relativeDensity + own * Kernel::w(L(0.0))) -
                    L(static_cast<Real>(in->selfExcess)) * own;
    int lanes = 0;  // number of particles, since the dummy row only pads the end of a group
    while (lanes < 8 && rows[lanes] != dummy) lanes++;
    constexpr Real together = Real(1e-20 / (unit * unit));
    if (any(s.closest < L(together)))
      for (int l = 0; l < lanes; l++) *in->coincident += s.closest[l] < together;
    if constexpr (Carried) {
      std::uint32_t all[8];
      for (int l = 0; l < 8; l++) all[l] = rows[l < lanes ? l : 0];
      Step step{*in->carry, *in, groupRows(all, lanes), scaledSums(i, s, total)};
      step.loadMaterials();
      step.s.diffusion = diffusionOf(s, step);
      if constexpr (Solids) step.s.nearby = nearbyOf(s, step);
      step.run();
    } else {
      for (int l = 0; l < lanes; l++) {
        in->relativeDensity[rows[l]] = static_cast<float>(total[l]);
        in->concentrationGradient[rows[l]] = single(-unit * scale * laneAt(s.gradient, l));
      }
    }
  }
  THAW_INLINE CarrySums<Real> scaledSums(const Data& i, const Sum& s, L total) const {
    const double h = in->support;
    const L k(static_cast<Real>(scale)), perSecond(static_cast<Real>(scale / h * unit)), length(unit),
        perMoment(static_cast<Real>(-scale * unit * unit));
    CarrySums<Real> r;
    r.relativeDensity = total;
    r.gradient = scaled(L(static_cast<Real>(-scale * unit)), s.gradient);
    if constexpr (Surfaces) {
      r.gradientSize = Corrected ? L(sizePerMoment) * perMoment * (s.moment.xx + s.moment.yy + s.moment.zz)
                                 : k * s.size;
      r.surface = scaled(length, s.surface);
    }
    if constexpr (Corrected) {
      r.moment = scaled(perMoment, s.moment);
      r.strain = scaled(perSecond, s.strain);
    } else {
      r.rate = perSecond * s.rate;
    }
    if constexpr (Mixed) r.liquidFraction = sizeOf(i.pressurePhaseHeat.b);
    if constexpr (Solids) {
      r.liquidKernelSum = s.liquidKernelSum + r.liquidFraction;
      r.solidShare = k * s.solids;
      r.solid = scaled(length, s.solid);
    }
    return r;
  }
  /// Rate (1/s) of density diffusion.
  THAW_INLINE L diffusionOf(const Sum& s, const Step& step) const {
    const L perSecond = L(static_cast<Real>(0.5 * in->carry->diffusion / in->support)) * step.soundSpeed;
    const L c2 = step.soundSpeed * step.soundSpeed;
    if constexpr (Solids) {
      return perSecond * (commonStiffness(step) * s.spread - L(unit) * s.column / c2);
    } else {
      // The hydrostatic part is the weight times the gradient of the relative density.
      const L perSlope = L(Kernel::laplacePerSlope) * perSecond, column = L(-unit) * fallOf(s.gradient);
      if constexpr (Mixed) return perSlope * (commonStiffness(step) * s.spread + column / c2);
      return perSlope * (s.spread + column);
    }
  }
  /// Mean compression of liquid neighbours, extrapolated along the weight to the particle.
  THAW_INLINE L nearbyOf(const Sum& s, const Step& step) const {
    const L depth = L(unit) * s.depth / (step.soundSpeed * step.soundSpeed);
    const L mean = (commonStiffness(step) * s.nearby - depth) / max(s.liquidKernelSum, L(1e-30));
    return select(s.liquidKernelSum > L(0.0), mean, L(0.0));
  }
  /// Ratio of the first liquid's stiffness, the unit of compressions in records, to the particle's own.
  THAW_INLINE L commonStiffness(const Step& step) const {
    return narrowed(Lanes<double>(in->carry->liquids[0].stiffness) / step.stiffness, L(0.0));
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
