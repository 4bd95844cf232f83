// SPDX-License-Identifier: Apache-2.0
// Sums of the incompressible pressure solver (core/flow/incompressible/): the constraint gradient applied to
// velocities, its transpose applied to pressures, and the diagonal of their product. Three terms of the pair
// sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Rate of the relative density: d delta_i / dt = s sum_j V_j (v_i - v_j) . grad W_ij (1/s).
template<class Real, class Kernel> struct Compression {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity;
  double* rate;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity;
  };
  struct Sum {
    L rate = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L approach = (i.velocityViscosity.a - j.velocityViscosity.a) * dx +
                       (i.velocityViscosity.b - j.velocityViscosity.b) * dy +
                       (i.velocityViscosity.c - j.velocityViscosity.c) * dz;
    s.rate += j.positionVolume.d * Kernel::slope(dx * dx + dy * dy + dz * dz) * approach;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) rate[rows[l]] = scale * static_cast<double>(s.rate[l]);
  }
};

/// Impulse of the pressures (N s): -s V_i sum_j V_j (k_i + k_j) grad W_ij; equal and opposite for j.
template<class Real, class Kernel> struct Impulse {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressurePhaseHeat;
  Vec3d* impulse;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, pressurePhaseHeat;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L k = j.positionVolume.d * Kernel::slope(dx * dx + dy * dy + dz * dz) *
                (i.pressurePhaseHeat.a + j.pressurePhaseHeat.a);
    s.x -= k * dx;
    s.y -= k * dy;
    s.z -= k * dz;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double V = scale * static_cast<double>(i.positionVolume.d[l]);
        impulse[rows[l]] = {V * static_cast<double>(s.x[l]), V * static_cast<double>(s.y[l]),
                            V * static_cast<double>(s.z[l])};
      }
  }
};

/// Parts of the diagonal: gradient of the relative density by the particle's own position (1/m), and sum_j
/// |gradient by j's position|^2 / m_j (1/(m^2 kg)); 1/m_j is pressurePhaseHeat.c.
template<class Real, class Kernel> struct Response {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressurePhaseHeat;
  Vec3d* slope;
  double* others;
  double slopeScale;
  struct Data {
    Lanes4<Real> positionVolume, pressurePhaseHeat;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0), others = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q2 = dx * dx + dy * dy + dz * dz, k = j.positionVolume.d * Kernel::slope(q2);
    s.x += k * dx;
    s.y += k * dy;
    s.z += k * dz;
    s.others += k * k * q2 * j.pressurePhaseHeat.c;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const std::uint32_t i = rows[l];
        slope[i] = {slopeScale * static_cast<double>(s.x[l]), slopeScale * static_cast<double>(s.y[l]),
                    slopeScale * static_cast<double>(s.z[l])};
        others[i] = slopeScale * slopeScale * static_cast<double>(s.others[l]);
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
