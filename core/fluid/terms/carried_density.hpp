// SPDX-License-Identifier: Apache-2.0
// Continuity density and concentration gradient. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/carry.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

enum class Carry { Nothing, Density, Corrected };
/// Particles of a sum: one liquid with records of Modules::uniform, several liquids, or liquids and solids
/// that carry the density of adjacent liquid (Crespo et al. 2007).
enum class Mix { One, Liquids, Solids };

/// Summed relative density (as Density) and h times its gradient, for shifting.
/// Carry::Density: also its rate, sum V0_j (u_i - u_j).grad W. The adjoint is the pressure force of Forces,
/// so pairs conserve energy (Bonet & Lok 1999).
/// Carry::Corrected: instead the sums for the corrected rate (terms/carry.hpp).
/// Both: density diffusion (Molteni & Colagrossi 2009, eq. 11) minus its hydrostatic part (Fourtakas 2019,
/// eq. 10), and the step of the carried density.
/// Gradients are those at mid-step: pressure work then equals the loss of compression energy to second order.
/// Several liquids or solids: the diffusing quantity is the pressure over a common stiffness.
/// Surfaces: also the sums of the free surface.
template<class Real, class Kernel, Carry carry, bool Surfaces = false, Mix mix = Mix::Solids>
struct CarriedDensity {
  using L = Lanes<Real>;
  static constexpr bool Carried = carry != Carry::Nothing, Corrected = carry == Carry::Corrected,
                        Mixed = mix != Mix::One, Solids = mix == Mix::Solids;
  using Step = CarryLanes<Real, Corrected, Surfaces, Mixed>;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat;
  const PairSums* in;
  double scale;
  L weight[3];  ///< h g; not Mixed: over c^2
  L half;       ///< s/m, half of the last step over h
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat;
  };
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
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    Vector3<L> d{positionDifference(i.positionVolume.a, j.positionVolume.a),
                 positionDifference(i.positionVolume.b, j.positionVolume.b),
                 positionDifference(i.positionVolume.c, j.positionVolume.c)};
    Vector3<L> u;
    if constexpr (Carried) {
      u = {i.velocityViscosity.a - j.velocityViscosity.a, i.velocityViscosity.b - j.velocityViscosity.b,
           i.velocityViscosity.c - j.velocityViscosity.c};
      add(d, -half, u.x, u.y, u.z);
    }
    const L q2 = dotOf(d, d), q = sqrt(q2),
            V = Carried && Surfaces && !Mixed ? sizeOf(j.positionVolume.d) : j.positionVolume.d;
    const L w = V * Kernel::w(q, q2), slope = V * Kernel::slope(q, q2);
    s.relativeDensity += w;
    s.closest = select(V > L(0.0), min(s.closest, q2), s.closest);
    const Vector3<L> g = scaled(slope, d);
    s.gradient.x += g.x;
    s.gradient.y += g.y;
    s.gradient.z += g.z;
    if constexpr (Surfaces) addSurface(j, g, s);
    if constexpr (Surfaces && !Corrected) s.size -= slope * q;
    if constexpr (Carried)
      addRate(i, j, {d, g, u, w, slope, Solids ? V * Kernel::laplace(q, q2) : L(0.0)}, s);
  }
  struct Pair {
    Vector3<L> d, g, u;   ///< h, 1/h, m/s: difference of positions, V grad W, difference of velocities
    L w, slope, laplace;  ///< V W, V W' / q, V times the kernel of the Laplacian
  };
  /// Adds the sums from which the free surface and adjacent solids are found.
  THAW_INLINE void addSurface(const Data& j, const Vector3<L>& g, Sum& s) const {
    const L mark = Mixed ? j.pressurePhaseHeat.b : j.positionVolume.d;
    const typename L::Mask marked = mark < L(0.0);
    // rare, except close to the free surface
    if (any(marked)) add(s.surface, select(marked, L(-1.0), L(0.0)), g.x, g.y, g.z);
    if constexpr (Solids) add(s.solid, sizeOf(mark) - L(1.0), g.x, g.y, g.z);
  }
  THAW_INLINE void addRate(const Data& i, const Data& j, const Pair& p, Sum& s) const {
    Vector3<L> g = p.g;
    L laplace = p.laplace;
    if constexpr (Solids) {
      const L fi = sizeOf(i.pressurePhaseHeat.b), fj = sizeOf(j.pressurePhaseHeat.b),
              pairLiquidFraction = fi + fj - fi * fj, wet = p.w * fj;
      s.liquidKernelSum += wet;
      s.solids += p.w - wet;
      s.nearby = fma(wet, j.pressurePhaseHeat.a, s.nearby);
      s.depth = fma(wet, fallOf(p.d), s.depth);
      g = scaled(pairLiquidFraction, g);
      laplace = pairLiquidFraction * laplace;
    }
    if constexpr (Corrected) {
      s.moment.xx -= p.g.x * p.d.x;
      s.moment.yy -= p.g.y * p.d.y;
      s.moment.zz -= p.g.z * p.d.z;
      s.moment.xy -= p.g.x * p.d.y;
      s.moment.yz -= p.g.y * p.d.z;
      s.moment.xz -= p.g.x * p.d.z;
      s.strain.xx = fma(g.x, p.u.x, s.strain.xx);
      s.strain.yy = fma(g.y, p.u.y, s.strain.yy);
      s.strain.zz = fma(g.z, p.u.z, s.strain.zz);
      s.strain.xy = fma(g.x, p.u.y, fma(g.y, p.u.x, s.strain.xy));
      s.strain.yz = fma(g.y, p.u.z, fma(g.z, p.u.y, s.strain.yz));
      s.strain.xz = fma(g.x, p.u.z, fma(g.z, p.u.x, s.strain.xz));
    } else {
      s.rate += dotOf(g, p.u);
    }
    if constexpr (Solids) {
      s.spread = fma(laplace, j.pressurePhaseHeat.a - i.pressurePhaseHeat.a, s.spread);
      s.column = fma(laplace, fallOf(p.d), s.column);
    } else {
      const L mine = Mixed ? i.pressurePhaseHeat.a : i.velocityViscosity.d,
              other = Mixed ? j.pressurePhaseHeat.a : j.velocityViscosity.d;
      s.spread = fma(p.slope, other - mine, s.spread);
    }
  }
  THAW_INLINE L fallOf(const Vector3<L>& d) const {
    return dot3(weight[0], weight[1], weight[2], d.x, d.y, d.z);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L own = Carried && Surfaces && !Mixed ? sizeOf(i.positionVolume.d) : i.positionVolume.d,
            total = L(static_cast<Real>(scale)) * (s.relativeDensity + own * Kernel::w(L(0.0))) -
                    L(static_cast<Real>(in->selfExcess)) * own;
    int lanes = 0;  // the dummy row only pads the end of a group
    while (lanes < 8 && rows[lanes] != dummy) lanes++;
    if (any(s.closest < L(1e-20)))
      for (int l = 0; l < lanes; l++) *in->coincident += s.closest[l] < Real(1e-20);
    if constexpr (Carried) {
      std::uint32_t all[8];
      for (int l = 0; l < 8; l++) all[l] = rows[l < lanes ? l : 0];
      Step step{*in->carry, *in, all, lanes, scaledSums(i, s, total)};
      step.loadMaterials();
      step.s.diffusion = diffusionOf(s, step);
      if constexpr (Solids) step.s.nearby = nearbyOf(s, step);
      step.run();
    } else {
      for (int l = 0; l < lanes; l++) {
        in->relativeDensity[rows[l]] = static_cast<float>(total[l]);
        in->concentrationGradient[rows[l]] = single(scale * laneAt(s.gradient, l));
      }
    }
  }
  /// h sum V |grad W| over the trace of the moment: 1.77 on a lattice with the default support, 1.81 in its
  /// outermost layer.
  static constexpr double sizePerMoment = 1.77;
  THAW_INLINE CarrySums<Real> scaledSums(const Data& i, const Sum& s, L total) const {
    const double h = in->support;
    const L k(static_cast<Real>(scale)), perSecond(static_cast<Real>(scale / h));
    CarrySums<Real> r;
    r.relativeDensity = total;
    r.gradient = scaled(k, s.gradient);
    if constexpr (Surfaces) {
      r.gradientSize = k *
                       (Corrected ? L(sizePerMoment) * (s.moment.xx + s.moment.yy + s.moment.zz) : s.size);
      r.surface = s.surface;
    }
    if constexpr (Corrected) {
      r.moment = scaled(k, s.moment);
      r.strain = scaled(perSecond, s.strain);
    } else {
      r.rate = perSecond * s.rate;
    }
    if constexpr (Mixed) r.liquidFraction = sizeOf(i.pressurePhaseHeat.b);
    if constexpr (Solids) {
      r.liquidKernelSum = s.liquidKernelSum + r.liquidFraction;
      r.solidShare = k * s.solids;
      r.solid = s.solid;
    }
    return r;
  }
  /// Rate (1/s) of density diffusion.
  THAW_INLINE L diffusionOf(const Sum& s, const Step& step) const {
    const L perSecond = L(static_cast<Real>(0.5 * in->carry->diffusion / in->support)) * step.soundSpeed;
    const L c2 = step.soundSpeed * step.soundSpeed;
    if constexpr (Solids) {
      return perSecond * (commonStiffness(step) * s.spread + s.column / c2);
    } else {
      // The hydrostatic part is the weight times the gradient of the relative density.
      const L perSlope = L(Kernel::laplacePerSlope) * perSecond, column = fallOf(s.gradient);
      if constexpr (Mixed) return perSlope * (commonStiffness(step) * s.spread + column / c2);
      return perSlope * (s.spread + column);
    }
  }
  /// Mean compression of liquid neighbours, extrapolated along the weight to the particle.
  THAW_INLINE L nearbyOf(const Sum& s, const Step& step) const {
    const L mean = (commonStiffness(step) * s.nearby + s.depth / (step.soundSpeed * step.soundSpeed)) /
                   max(s.liquidKernelSum, L(1e-30));
    return select(s.liquidKernelSum > L(0.0), mean, L(0.0));
  }
  /// Stiffness of the first liquid, the unit of compressions in records, over the particle's own.
  THAW_INLINE L commonStiffness(const Step& step) const {
    return narrowed(Lanes<double>(in->carry->liquids[0].stiffness) / step.stiffness, L(0.0));
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
