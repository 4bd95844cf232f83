// SPDX-License-Identifier: Apache-2.0
// The step of carried densities of eight particles, from their sums over neighbours (carried_density.hpp). It
// computes the free surface, gradient correction, shifting, and relative density at the end of the step.
#pragma once
#include "core/fluid/laws/free_surface.hpp"
#include "core/fluid/pair_sums/carry.hpp"
#include "core/fluid/terms/rows.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/materials/liquid_materials.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

THAW_INLINE LanesF sizeOf(LanesF a) {
  return LanesF(reinterpret_cast<Vec8f>(reinterpret_cast<Vec8i>(a.v) & 0x7fffffff));
}
THAW_INLINE LanesD sizeOf(LanesD a) { return max(a, -a); }
template<class L> THAW_INLINE L clamped(L a, L least, L most) { return min(max(a, least), most); }

template<class L> THAW_INLINE Vec3d laneAt(const Vector3<L>& v, int l) {
  return {static_cast<double>(v.x[l]), static_cast<double>(v.y[l]), static_cast<double>(v.z[l])};
}

template<class L> THAW_INLINE Tensor<L> scaled(L k, const Tensor<L>& a) {
  return {k * a.xx, k * a.yy, k * a.zz, k * a.xy, k * a.yz, k * a.xz};
}
/// Returns the mask of the lanes in which all eigenvalues exceed `least` (Sylvester's criterion).
template<class L> THAW_INLINE typename L::Mask eigenvaluesAbove(const Tensor<L>& m, L least) {
  const L zero(0.0), a = m.xx - least, b = m.yy - least, c = m.zz - least;
  return (a > zero) & (a * b - m.xy * m.xy > zero) &
         (a * (b * c - m.yz * m.yz) - m.xy * (m.xy * c - m.yz * m.xz) + m.xz * (m.xy * m.yz - b * m.xz) >
          zero);
}

/// Sums over the neighbours of eight particles. Lengths are in support radii.
template<class Real> struct CarrySums {
  using L = Lanes<Real>;
  L relativeDensity = L(0.0), rate = L(0.0), diffusion = L(0.0);  ///< 1, 1/s, 1/s
  L gradientSize = L(0.0), liquidFraction = L(1.0);
  L liquidKernelSum = L(1.0);  ///< sum V W of liquid; above 0 with liquid nearby
  L solidShare = L(0.0);       ///< sum V W of solids over its lattice value
  L nearby = L(0.0);           ///< carried compression of liquid neighbours, extrapolated to the particle
  Vector3<L> gradient;         ///< gradient of the relative density
  Vector3<L> surface, solid;   ///< directions away from neighbours at the free surface, and away from solid
                               ///< neighbours
  Tensor<L> moment;
  Tensor<L> strain;  ///< 1/s, minus the rate of strain; sums of both halves off the diagonal
};

/// Advances eight particles. Mixed: several liquids, or solids that carry the density of adjacent liquid.
template<class Real, bool Corrected, bool Surfaces, bool Mixed> struct CarryLanes {
  using L = Lanes<Real>;
  using Wide = Lanes<double>;
  const CarryStep& x;
  const PairSums& in;
  GroupRows at;
  CarrySums<Real> s;
  LaneBits awake = 0;     ///< lanes of particles that the step changes
  LaneBits inLiquid = 0;  ///< lanes of awake particles with liquid nearby
  L soundSpeed = L(1.0), atSurface = L(0.0), besideSurface = L(0.0);
  Wide stiffness = Wide(1.0), restVolume = Wide(1.0), compression = Wide(0.0);
  Wide pressureLead = Wide(0.0), lead = Wide(0.0);  ///< s, LiquidMaterial::pressureLead; 1, change of the
                                                    ///< relative density in that time

  template<class Column> THAW_INLINE Wide fromRows(Column column) const {
    Wide v;
    for (int l = 0; l < 8; l++) setLane(v, l, column(at.row[l]));
    return v;
  }
  THAW_INLINE void findLanes() {
    if (!Mixed && !x.steady) {
      awake = inLiquid = (1u << at.count) - 1;
      return;
    }
    for (int l = 0; l < at.count; l++) {
      const bool isAwake = !x.steady || !x.steady[at.row[l]];
      awake |= unsigned{isAwake} << l;
      inLiquid |= unsigned{isAwake && (!Mixed || s.liquidKernelSum[l] > 0)} << l;
    }
  }

  THAW_INLINE void run() {
    findLanes();
    if constexpr (Surfaces) findFreeSurface();
    if (x.walls.beside) addWalls();
    if (x.summed)
      for (int l = 0; l < at.count; l++) x.summed[at.row[l]] = static_cast<float>(s.relativeDensity[l]);
    countCompressed();
    if constexpr (Surfaces) shift();
    Tensor<L> now, next;
    if constexpr (Corrected) correct(now, next);
    const Wide end = carry();
    store(now, next, end);
  }

  THAW_INLINE void loadMaterials() {
    const auto of = [&](std::uint32_t row) -> const LiquidMaterial& {
      return x.liquids[Mixed ? x.material[row] : 0];
    };
    if constexpr (Mixed) {
      soundSpeed = narrowed(fromRows([&](std::uint32_t row) { return of(row).soundSpeed; }), L(0.0));
      stiffness = fromRows([&](std::uint32_t row) { return of(row).stiffness; });
      pressureLead = fromRows([&](std::uint32_t row) { return of(row).pressureLead; });
      restVolume = x.restDensity
                       ? at.doubles(x.mass) / at.doubles(x.restDensity)
                       : at.doubles(x.mass) * fromRows([&](std::uint32_t row) { return of(row).restVolume; });
    } else {
      restVolume = at.doubles(x.mass) * Wide(of(0).restVolume);
      soundSpeed = L(static_cast<Real>(of(0).soundSpeed));
      stiffness = Wide(of(0).stiffness);
      pressureLead = Wide(of(0).pressureLead);
    }
    compression = at.doubles(x.compression);
  }

  /// Mask of the particles whose neighbours are mostly on one side.
  THAW_INLINE typename L::Mask oneSided() const {
    const L limit = L(surfaceAsymmetry) * s.gradientSize;
    return dotOf(s.gradient, s.gradient) > limit * limit;
  }

  /// Marks the free surface by the moment of the neighbourhood, or by its asymmetry if there are no moments.
  THAW_INLINE void findFreeSurface() {
    const L one(1.0), zero(0.0);
    const L inside = Corrected ? select(eigenvaluesAbove(s.moment, L(surfaceMoment)), one, zero)
                               : select(oneSided(), zero, one);
    atSurface = select(s.liquidFraction > zero, one - inside, zero);
    const L largest = max(max(sizeOf(s.surface.x), sizeOf(s.surface.y)), sizeOf(s.surface.z));
    besideSurface = select(largest > L(1e-6), one, zero);
  }

  void addWalls() {
    for (int l = 0; l < at.count; l++) {
      if (!x.walls.beside[at.row[l]]) continue;
      const Sym3d moment{static_cast<double>(s.moment.xx[l]), static_cast<double>(s.moment.yy[l]),
                         static_cast<double>(s.moment.zz[l]), static_cast<double>(s.moment.xy[l]),
                         static_cast<double>(s.moment.yz[l]), static_cast<double>(s.moment.xz[l])};
      CarryRow r{static_cast<double>(s.relativeDensity[l]),
                 static_cast<double>(s.rate[l]),
                 laneAt(s.gradient, l),
                 moment,
                 static_cast<double>(s.gradientSize[l]),
                 static_cast<double>(s.liquidFraction[l])};
      x.walls.add(x.walls.context, at.row[l], r);
      setLane(s.relativeDensity, l, r.relativeDensity), setLane(s.rate, l, r.rate);
      setLane(s.gradient.x, l, r.gradient.x), setLane(s.gradient.y, l, r.gradient.y);
      setLane(s.gradient.z, l, r.gradient.z);
      setLane(s.moment.xx, l, r.moment.xx), setLane(s.moment.yy, l, r.moment.yy);
      setLane(s.moment.zz, l, r.moment.zz), setLane(s.moment.xy, l, r.moment.xy);
      setLane(s.moment.yz, l, r.moment.yz), setLane(s.moment.xz, l, r.moment.xz);
      if constexpr (Surfaces) setLane(atSurface, l, r.atSurface);
    }
  }

  THAW_INLINE void countCompressed() {
    constexpr double largestDensityRatio = 1.3;
    const L carried = narrowed(compression, L(0.0));
    const typename L::Mask crowded = (s.relativeDensity > L(largestDensityRatio) * (L(1.0) + carried)) &
                                     (s.liquidFraction > L(0.0)) & (s.liquidKernelSum > L(0.0));
    if (!any(crowded)) return;
    for (int l = 0; l < at.count; l++) *x.crowded += laneOf(crowded, l) && awake >> l & 1;
  }

  /// Velocity of shifting (m/s), along -grad C (LXSR12). The speed is at most CarryStep::shifting
  /// times the speed of sound. Below that, it is proportional to the causes of disorder: strain, and tension
  /// (a speed of sqrt(|p| / rho)). Liquid at rest is thus not shifted. Particles at the free surface are not
  /// shifted, and particles next to it are not shifted towards it (S17 eq. 20). Particles next to a solid are
  /// shifted only along it. Shifting must keep the gap, since a few per cent of the displaced volume decide
  /// whether the solid floats.
  THAW_INLINE void shift() {
    const L zero(0.0);
    L speed = L(x.shifting) * soundSpeed;
    if constexpr (Corrected) {
      const L tension = soundSpeed * sqrt(max(-narrowed(compression, zero), zero));
      const Tensor<L>& e = s.strain;
      const L rate = sqrt(L(2.0) * dot3(e.xx, e.yy, e.zz, e.xx, e.yy, e.zz) +
                          dot3(e.xy, e.yz, e.xz, e.xy, e.yz, e.xz));
      speed = min(speed, L(shiftPerStrain * in.support) * rate + L(shiftPerTension) * tension);
    }
    speed = select((s.liquidFraction < L(1.0)), zero, speed);
    speed = select(atSurface > zero, zero, speed);
    Vector3<L> u = scaled(-speed, s.gradient);
    const L outwards = min(dotOf(u, s.surface), zero) / max(dotOf(s.surface, s.surface), L(1e-30));
    addScaled(u, select(besideSurface > zero, -outwards, zero), s.surface.x, s.surface.y, s.surface.z);
    if constexpr (Mixed) {
      const L size2 = dotOf(s.solid, s.solid);
      const L across = dotOf(u, s.solid) / max(size2, L(1e-30));
      addScaled(u, select(size2 > L(besideSolid * besideSolid), -across, zero), s.solid.x, s.solid.y,
                s.solid.z);
    }
    write(at, awake, u.x, u.y, u.z, x.shiftingVelocity);
    if (!x.walls.beside) return;
    for (int l = 0; l < at.count; l++)
      if (awake >> l & 1 && x.walls.beside[at.row[l]])
        x.shiftingVelocity[at.row[l]] = x.walls.along(x.walls.context, at.row[l], laneAt(u, l));
  }

  /// Inverse moment minus 1, times a weight. The weight is 1 from a summed relative density of 0.95 on. It is
  /// 0 up to 0.9, where a free surface truncates the sums. It is 0 if neighbours are on one side, as at the
  /// surface of a thin jet. Compressed particles that reach 0.9 there would oscillate. It is also 0 if an
  /// eigenvalue is below 0.4, since corrections above 2.5 would be unstable at this step.
  THAW_INLINE Tensor<L> correctionNow() const {
    const Tensor<L>& m = s.moment;
    const L zero(0.0), one(1.0);
    L weight = clamped((s.relativeDensity - L(0.9)) * L(1 / 0.05), zero, one);
    weight = select(eigenvaluesAbove(m, L(0.4)), weight, zero);
    weight = select(oneSided(), zero, weight);
    if constexpr (Mixed) weight = select(s.liquidKernelSum > zero, weight, zero);
    const L xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
    const L determinant = m.xx * xx + m.xy * xy + m.xz * xz;
    const L k = weight / select(weight > zero, determinant, one);
    return {
        k * xx - weight, k * (m.xx * m.zz - m.xz * m.xz) - weight, k * (m.xx * m.yy - m.xy * m.xy) - weight,
        k * xy,          k * (m.xy * m.xz - m.xx * m.yz),          k * xz};
  }

  /// Adds the corrected divergence at mid-step to the rate. Extrapolates the correction from the last two
  /// mid-steps to the end of the step, with a limited change.
  THAW_INLINE void correct(Tensor<L>& d, Tensor<L>& next) {
    constexpr double most = 0.1;
    d = correctionNow();
    const Tensor<L>& e = s.strain;
    const L one(1.0);
    s.rate += dot3(one + d.xx, one + d.yy, one + d.zz, e.xx, e.yy, e.zz) +
              dot3(d.xy, d.yz, d.xz, e.xy, e.yz, e.xz);
    const L ahead(static_cast<Real>(x.ahead));
    const Tensor<L> before = tensors<L>(at, x.midCorrection);
    const auto extrapolated = [&](L now, L then) {
      return fma(ahead, clamped(now - then, L(-most), L(most)), now);
    };
    next = {extrapolated(d.xx, before.xx), extrapolated(d.yy, before.yy), extrapolated(d.zz, before.zz),
            extrapolated(d.xy, before.xy), extrapolated(d.yz, before.yz), extrapolated(d.xz, before.xz)};
  }

  /// Pressure term p / delta^2 (Pa) at a relative density of 1 + y.
  THAW_INLINE Wide pressureTerm(Wide y) const {
    const Wide f = Wide(1.0) + y, f2 = f * f;
    const Wide p = x.eos == EquationOfState::Linear
                       ? stiffness * y
                       : stiffness * Wide(1.0 / 7) * (f2 * f2 * f2 * f - Wide(1.0));
    return select(p < Wide(0.0), Wide(x.tensileLimit) * p, p) / f2;
  }

  /// Drift correction: change of the carried relative density in this step towards the summed one. It is
  /// needed since shifting, splashing and clipped tension move particles without changing the carried
  /// density. Inside the liquid the correction is slow, so that disorder causes no pressure noise, and it
  /// never causes tension. Next to the free surface, only the part counts that truncation of the sum cannot
  /// explain, such as voids of a splash. An excess above `tolerated` decays faster, even at the surface. off:
  /// summed minus carried relative density; steps: c dt / h.
  THAW_INLINE Wide driftCorrection(Wide off, Wide carried, Wide steps) const {
    constexpr double perStep = 0.01, crowdedPerStep = 0.05, tolerated = 0.03, truncated = 0.1;
    const Wide zero(0.0), one(1.0), beside = widen(besideSurface), at = widen(atSurface);
    Wide drift = select(beside > zero, min(zero, off + Wide(truncated)), off);
    drift = select(at > zero, zero, drift);
    const Wide back = max(min(one, Wide(perStep) * steps) * drift, -max(zero, carried));
    return back + min(one, Wide(crowdedPerStep) * steps) * max(zero, off - Wide(tolerated));
  }

  /// Share of the difference from nearby liquid by which a solid's density approaches it per acoustic time
  /// h/c [A12]. The density of the liquid is that of the previous step, so a share near 1 would amplify
  /// sound.
  static constexpr double towardsLiquidNearby = 0.5;

  /// Returns the relative density minus 1 at the end of the step. Records the compression energy that
  /// diffusion and drift correction change.
  THAW_INLINE Wide carry() {
    const Wide before = compression, dt(x.dt), zero(0.0), one(1.0);
    const Wide flow = before + widen(s.rate) * dt;
    Wide spread = widen(s.diffusion) * dt;
    const Wide steps = widen(soundSpeed) * Wide(x.dt / in.support), f = widen(s.liquidFraction);
    Wide drift = zero;
    if constexpr (Surfaces)
      drift = driftCorrection(widen(s.relativeDensity) - one - flow - spread, flow + spread, steps);
    if constexpr (Mixed) {
      const Wide nearby = min(one, Wide(towardsLiquidNearby) * steps) * (widen(s.nearby) - before);
      drift = select(f < one, zero, drift);
      if (x.solids) drift = select(f > zero, drift, nearby);
    }
    spread = spread + drift;
    // Mean over both ends of the step, as for the pressure work of the flow.
    const Wide half = Wide(0.5) * spread;
    const Wide energy = half * restVolume * (pressureTerm(flow + half) + pressureTerm(before + half));
    const Wide end = flow + spread;
    recordChange(end - before);
    write(at, inLiquid, at.doubles(x.dissipated) - energy + (x.compressionRate ? damp(end) : zero),
          x.dissipated);
    return end;
  }

  THAW_INLINE void recordChange(Wide change) {
    const Wide size = sizeOf(change);
    if (!any(size > Wide(*x.largestChange))) return;
    for (int l = 0; l < at.count; l++)
      if (inLiquid >> l & 1) *x.largestChange = std::max(*x.largestChange, size[l]);
  }

  /// Makes the pressure lead the density by a fixed time t: p(y + t dy/dt). This is a volume viscosity, which
  /// damps sound but not shear. Returns the dissipated energy (J), from the mean of the leads at both ends of
  /// the step.
  THAW_INLINE Wide damp(Wide end) {
    if (!(x.dt > 0)) return Wide(0.0);
    const Wide rate = widen(s.rate), before = widen(at.floats(x.compressionRate));
    lead = pressureLead * rate;
    write(at, inLiquid, toFloats(s.rate), x.compressionRate);
    const Wide pressure = pressureTerm(end);
    const Wide both = pressureTerm(end + lead) + pressureTerm(end + pressureLead * before) - pressure -
                      pressure;
    return Wide(0.5 * x.dt) * rate * restVolume * both;
  }

  THAW_INLINE void store(const Tensor<L>& now, const Tensor<L>& next, Wide end) {
    if constexpr (Surfaces) writeFlags(at, awake, toFloats(atSurface), x.atSurface);
    write(at, inLiquid, end, x.compression);
    write(at, inLiquid, toFloats(Wide(1.0) + end + lead), in.relativeDensity);
    if constexpr (Corrected) {
      write(at, inLiquid, now, x.midCorrection);
      write(at, inLiquid, next, x.correction);
    }
    if constexpr (Mixed)
      for (int l = 0; l < at.count; l++) {
        if (!(awake >> l & 1)) continue;
        if (!(inLiquid >> l & 1)) resetCarriedDensity(x, in.relativeDensity, at.row[l]);
        else if (Surfaces && x.relief) storeRelief(l, end[l]);
      }
  }

  THAW_INLINE void storeRelief(int l, double end) {
    const std::uint32_t row = at.row[l];
    x.relief[row] = {};
    const bool inside = s.liquidFraction[l] == 1 && !(atSurface[l] > 0) && !(besideSurface[l] > 0);
    if (!inside || !(s.solidShare[l] > 0)) return;
    const double pressure = pressureTerm(Wide(end))[l] * (1 + end) * (1 + end);
    x.relief[row] = latticeRelief({pressure, restVolume[l], static_cast<double>(s.solidShare[l]), in.support,
                                   laneAt(s.gradient, l), laneAt(s.solid, l)});
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
