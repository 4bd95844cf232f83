// SPDX-License-Identifier: Apache-2.0
// Continuity density and concentration gradient. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"
#include "core/materials/liquid_materials.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

enum class Carry { Nothing, Density, Corrected };

/// Summed relative density (as Density) and h times its gradient, for shifting.
/// Carry::Density: also its rate, sum V0_j (u_i - u_j).grad W. The adjoint is the pressure force of Forces,
/// so pairs conserve energy (Bonet & Lok 1999).
/// Carry::Corrected: instead the sums for the corrected rate (core/fluid/density/carried_density.cpp).
/// Both: density diffusion (Molteni & Colagrossi 2009, eq. 11) minus its hydrostatic part (Fourtakas 2019,
/// eq. 10).
/// Gradients are those at mid-step: pressure work then equals the loss of compression energy to second order.
/// Mixed: several liquids, or solids that carry the density of adjacent liquid (Crespo et al. 2007).
/// The diffusing quantity is then the pressure over a common stiffness.
/// Surfaces: also the sums of the free-surface indicator.
template<class Real, class Kernel, Carry carry, bool Surfaces = false, bool Mixed = true>
struct CarriedDensity {
  using L = Lanes<Real>;
  static constexpr bool Carried = carry != Carry::Nothing, Corrected = carry == Carry::Corrected;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat;
  const PairSums* in;
  double scale;
  L weight[3];  ///< h g; not Mixed: over c^2
  L half;       ///< s/m, half of the last step over h
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat;
  };
  struct Vector {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  struct Sum {
    L relativeDensity = L(0.0), closest = L(1.0), rate = L(0.0), spread = L(0.0), column = L(0.0),
      size = L(0.0), liquidKernelSum = L(0.0), solids = L(0.0), nearby = L(0.0), depth = L(0.0);
    Vector concentrationGradient, surface, solid, negativeVelocityGradient[3];
    L moment[6] = {L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0)};
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    if constexpr (Carried) d.velocityViscosity = loadListed(velocityViscosity, entries);
    if constexpr (Carried && Mixed) d.pressurePhaseHeat = loadListed(pressurePhaseHeat, entries);
    return d;
  }
  static THAW_INLINE L size(L a) { return max(a, -a); }
  static THAW_INLINE void add(Vector& to, L factor, L x, L y, L z) {
    to.x = fma(factor, x, to.x);
    to.y = fma(factor, y, to.y);
    to.z = fma(factor, z, to.z);
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
      dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
      dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    L ux, uy, uz;
    if constexpr (Carried) {
      ux = i.velocityViscosity.a - j.velocityViscosity.a, uy = i.velocityViscosity.b - j.velocityViscosity.b,
      uz = i.velocityViscosity.c - j.velocityViscosity.c;
      dx -= half * ux, dy -= half * uy, dz -= half * uz;
    }
    const L q2 = dx * dx + dy * dy + dz * dz, q = sqrt(q2),
            V = Carried && Surfaces && !Mixed ? size(j.positionVolume.d) : j.positionVolume.d;
    const L w = V * Kernel::w(q, q2), g = V * Kernel::slope(q, q2);
    s.relativeDensity += w;
    s.closest = select(V > L(0.0), min(s.closest, q2), s.closest);
    const L gx = g * dx, gy = g * dy, gz = g * dz;
    s.concentrationGradient.x += gx;
    s.concentrationGradient.y += gy;
    s.concentrationGradient.z += gz;
    if constexpr (Carried) {
      L pairLiquidFraction = L(1.0), solidFraction = L(0.0);
      if constexpr (Mixed) {
        const L fi = size(i.pressurePhaseHeat.b), fj = size(j.pressurePhaseHeat.b);
        pairLiquidFraction = fi + fj - fi * fj;
        solidFraction = L(1.0) - fj;
        s.liquidKernelSum += w * fj;
        s.solids += w * solidFraction;
      }
      if constexpr (Surfaces) {
        s.size -= g * q;
        const L marked = select((Mixed ? j.pressurePhaseHeat.b : j.positionVolume.d) < L(0.0), L(-1.0),
                                L(0.0));
        add(s.surface, marked, gx, gy, gz);
        if constexpr (Mixed) add(s.solid, -solidFraction, gx, gy, gz);
      }
      if constexpr (Corrected) {
        s.moment[0] -= gx * dx;
        s.moment[1] -= gy * dy;
        s.moment[2] -= gz * dz;
        s.moment[3] -= gx * dy;
        s.moment[4] -= gy * dz;
        s.moment[5] -= gx * dz;
        add(s.negativeVelocityGradient[0], pairLiquidFraction * gx, ux, uy, uz);
        add(s.negativeVelocityGradient[1], pairLiquidFraction * gy, ux, uy, uz);
        add(s.negativeVelocityGradient[2], pairLiquidFraction * gz, ux, uy, uz);
      } else {
        s.rate += pairLiquidFraction * (gx * ux + gy * uy + gz * uz);
      }
      const L both = V * Kernel::laplace(q, q2) * pairLiquidFraction,
              down = weight[0] * dx + weight[1] * dy + weight[2] * dz;
      if constexpr (Mixed) {
        s.spread += both * (j.pressurePhaseHeat.a - i.pressurePhaseHeat.a);
        s.column += both * down;
        s.nearby += w * size(j.pressurePhaseHeat.b) * j.pressurePhaseHeat.a;
        s.depth += w * size(j.pressurePhaseHeat.b) * down;
      } else {
        s.spread += both * (j.velocityViscosity.d - i.velocityViscosity.d + down);
      }
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L own = Carried && Surfaces && !Mixed ? size(i.positionVolume.d) : i.positionVolume.d,
            total = s.relativeDensity + own * Kernel::w(L(0.0));
    const bool touching = any(s.closest < L(1e-20));
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const std::uint32_t row = rows[l];
        in->relativeDensity[row] = static_cast<float>(scale * static_cast<double>(total[l]) -
                                                      in->selfExcess * static_cast<double>(own[l]));
        if (touching && s.closest[l] < Real(1e-20)) ++*in->coincident;
        if (in->concentrationGradient)
          in->concentrationGradient[row] = single(scale * at(s.concentrationGradient, l));
        if constexpr (Carried) finishCarried(row, l, i, s);
      }
  }
  static THAW_INLINE Vec3d at(const Vector& v, int l) {
    return {static_cast<double>(v.x[l]), static_cast<double>(v.y[l]), static_cast<double>(v.z[l])};
  }
  THAW_INLINE void finishCarried(std::uint32_t row, int l, const Data& i, const Sum& s) const {
    const double h = in->support;
    if constexpr (Surfaces) {
      in->surfaceNormal[row] = single(at(s.surface, l));
      if (in->solidNormal) in->solidNormal[row] = single(at(s.solid, l));
      in->gradientSize[row] = static_cast<float>(scale * static_cast<double>(s.size[l]));
    }
    if constexpr (Corrected) {
      const auto m = [&](int k) { return static_cast<float>(scale * static_cast<double>(s.moment[k][l])); };
      in->moment[row] = {m(0), m(1), m(2), m(3), m(4), m(5)};
      for (int a = 0; a < 3; a++)
        in->negativeVelocityGradient[row].row[a] = single(scale / h * at(s.negativeVelocityGradient[a], l));
    }
    in->densityRate[row] = scale / h * static_cast<double>(s.rate[l]);
    const LiquidMaterial& m = in->liquids[in->material[row]];
    double spread = static_cast<double>(s.spread[l]);
    if constexpr (Mixed) {
      const double c2 = m.soundSpeed * m.soundSpeed;
      spread = (in->stiffness * spread + m.stiffness / c2 * static_cast<double>(s.column[l])) / m.stiffness;
      if (in->liquidKernelSum) {
        const double liquid = static_cast<double>(s.liquidKernelSum[l]);
        in->liquidKernelSum[row] = static_cast<float>(liquid +
                                                      static_cast<double>(size(i.pressurePhaseHeat.b)[l]));
        in->solidKernelSum[row] = static_cast<float>(scale * static_cast<double>(s.solids[l]));
        in->liquidNearby[row] = liquid > 0 ? static_cast<float>(
                                                 (in->stiffness * static_cast<double>(s.nearby[l]) +
                                                  m.stiffness / c2 * static_cast<double>(s.depth[l])) /
                                                 (m.stiffness * liquid))
                                           : 0;
      }
    }
    in->densityDiffusionRate[row] = in->diffusion * 0.5 * m.soundSpeed / h * spread;
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
