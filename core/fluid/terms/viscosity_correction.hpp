// SPDX-License-Identifier: Apache-2.0
// Correction of the pairwise viscosity. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/laws/viscosity_factor.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/kernels/viscous_weight.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Sums for viscosityFactor() over the neighbours of liquid particles, and its result minus 1.
template<class Real, class Kernel> struct ViscosityCorrection {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat;
  const PairSums* in;
  L viscousWeight;
  double scale;  ///< turns sums over V W into relative densities
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat;
  };
  struct Sum {  ///< ViscousNeighbours
    L relativeDensity = L(0.0), second[6] = {}, velocity[9] = {}, fourth[21] = {};
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries),
            loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L d[3] = {positionDifference(i.positionVolume.a, j.positionVolume.a),
                    positionDifference(i.positionVolume.b, j.positionVolume.b),
                    positionDifference(i.positionVolume.c, j.positionVolume.c)};
    const L u[3] = {i.velocityViscosity.a - j.velocityViscosity.a,
                    i.velocityViscosity.b - j.velocityViscosity.b,
                    i.velocityViscosity.c - j.velocityViscosity.c};
    const L q2 = dot3(d[0], d[1], d[2], d[0], d[1], d[2]), q = sqrt(q2), V = j.positionVolume.d;
    const L fi = i.pressurePhaseHeat.b, fj = j.pressurePhaseHeat.b;
    s.relativeDensity = fma(V, Kernel::w(q, q2), s.relativeDensity);
    const L a = (fi + fj - fi * fj) * V * weightAt(viscousWeight, q) / max(q2, L(1e-12));
    const L p[6] = {d[0] * d[0], d[1] * d[1], d[2] * d[2], d[0] * d[1], d[1] * d[2], d[0] * d[2]};
    for (int k = 0, m = 0; k < 6; k++) {
      const L ap = a * p[k];
      s.second[k] += ap;
      for (int l = k; l < 6; l++, m++) s.fourth[m] = fma(ap, p[l], s.fourth[m]);
    }
    for (int k = 0; k < 3; k++) {
      const L au = a * u[k];
      for (int l = 0; l < 3; l++) s.velocity[3 * k + l] = fma(au, d[l], s.velocity[3 * k + l]);
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L own = i.positionVolume.d,
            total = L(static_cast<Real>(scale)) * (s.relativeDensity + own * Kernel::w(L(0.0))) -
                    L(static_cast<Real>(in->selfExcess)) * own;
    for (int l = 0; l < 8; l++) {
      if (rows[l] == dummy) continue;
      float& correction = in->viscosityCorrection[rows[l]];
      correction = 0;
      if (i.pressurePhaseHeat.b[l] < Real(1)) continue;  // solid or melting
      ViscousNeighbours n;
      n.relativeDensity = static_cast<double>(total[l]);
      if (in->viscosityWalls) {
        const WallShare& walls = in->viscosityWalls[rows[l]];
        n.relativeDensity += static_cast<double>(walls.density);
        n.wallShear = static_cast<double>(walls.shear);
      }
      for (int k = 0; k < 6; k++) n.second[k] = static_cast<double>(s.second[k][l]);
      for (int k = 0; k < 9; k++) n.velocity[k] = static_cast<double>(s.velocity[k][l]);
      for (int k = 0; k < 21; k++) n.fourth[k] = static_cast<double>(s.fourth[k][l]);
      correction = static_cast<float>(viscosityFactor(n, in->largestViscosityFactor) - 1);
    }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
