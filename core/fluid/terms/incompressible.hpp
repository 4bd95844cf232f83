// SPDX-License-Identifier: Apache-2.0
// Sums of the incompressible pressure solver (core/flow/incompressible/): the constraint gradient applied to
// velocities, its transpose applied to pressures, and the diagonal of their product. Three terms of the pair
// sums (term.hpp).
#pragma once
#include "core/fluid/terms/lane_vectors.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/math/mat3.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Rate of the relative density: d delta_i / dt = s sum_j V_j (v_i - v_j) . L_i grad W_ij (1/s). L_i is the
/// gradient correction, 1 + PairSums::correction. Without Corrected, L_i is 1.
template<class Real, class Kernel, bool Corrected> struct Compression {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity;
  const Sym3f* correction;
  double* rate;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity;
  };
  struct Sum {
    L rate = L(0.0);
    Tensor<L> strain;
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L ux = i.velocityViscosity.a - j.velocityViscosity.a,
            uy = i.velocityViscosity.b - j.velocityViscosity.b,
            uz = i.velocityViscosity.c - j.velocityViscosity.c;
    const L k = j.positionVolume.d * Kernel::slope(dx * dx + dy * dy + dz * dz);
    if constexpr (Corrected) {
      const L gx = k * dx, gy = k * dy, gz = k * dz;
      s.strain.xx += gx * ux;
      s.strain.yy += gy * uy;
      s.strain.zz += gz * uz;
      s.strain.xy += gx * uy + gy * ux;
      s.strain.xz += gx * uz + gz * ux;
      s.strain.yz += gy * uz + gz * uy;
    } else {
      s.rate += k * (ux * dx + uy * dy + uz * dz);
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) rate[rows[l]] = scale * rateOf(s, rows[l], l);
  }
  THAW_INLINE double rateOf(const Sum& s, std::uint32_t row, int l) const {
    if constexpr (!Corrected) return static_cast<double>(s.rate[l]);
    const auto at = [l](const L& v) { return static_cast<double>(v[l]); };
    const Sym3d d = wide(correction[row]);
    return at(s.strain.xx) * (1 + d.xx) + at(s.strain.yy) * (1 + d.yy) + at(s.strain.zz) * (1 + d.zz) +
           at(s.strain.xy) * d.xy + at(s.strain.xz) * d.xz + at(s.strain.yz) * d.yz;
  }
};

/// Impulse of the pressures (N s): -s V_i sum_j V_j (k_i L_i + k_j L_j) grad W_ij; equal and opposite for j.
/// It is the transpose of Compression. Corrected: the tensors k L are pressureDiagonal (xx yy zz) and
/// pressureOffDiagonal (xy xz yz). Otherwise k is pressurePhaseHeat.a.
template<class Real, class Kernel, bool Corrected> struct Impulse {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressure, *offDiagonal;
  Vec3d* impulse;
  double scale;
  struct Data {
    Lanes4<Real> positionVolume, pressure, offDiagonal;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d;
    d.positionVolume = loadListed(positionVolume, entries);
    d.pressure = loadListed(pressure, entries);
    if constexpr (Corrected) d.offDiagonal = loadListed(offDiagonal, entries);
    return d;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L k = j.positionVolume.d * Kernel::slope(dx * dx + dy * dy + dz * dz),
            xx = i.pressure.a + j.pressure.a;
    if constexpr (Corrected) {
      const L yy = i.pressure.b + j.pressure.b, zz = i.pressure.c + j.pressure.c,
              xy = i.offDiagonal.a + j.offDiagonal.a, xz = i.offDiagonal.b + j.offDiagonal.b,
              yz = i.offDiagonal.c + j.offDiagonal.c;
      s.x -= k * dot3(xx, xy, xz, dx, dy, dz);
      s.y -= k * dot3(xy, yy, yz, dx, dy, dz);
      s.z -= k * dot3(xz, yz, zz, dx, dy, dz);
    } else {
      s.x -= k * xx * dx;
      s.y -= k * xx * dy;
      s.z -= k * xx * dz;
    }
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

/// Parts of the diagonal and of the gradient correction, all before the correction. The first two are the
/// gradient of the relative density with respect to the particle's own position (1/m), and the moment of the
/// neighbourhood (1). The third is sum_j g_j g_j^T / m_j (1/(m^2 kg)). Here g_j are the gradients with
/// respect to the neighbours' positions, and 1/m_j is pressurePhaseHeat.c.
template<class Real, class Kernel> struct Response {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressurePhaseHeat;
  const PairSums* in;
  struct Data {
    Lanes4<Real> positionVolume, pressurePhaseHeat;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
    Tensor<L> moment, others;
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L k = j.positionVolume.d * Kernel::slope(dx * dx + dy * dy + dz * dz),
            m = k * k * j.pressurePhaseHeat.c;
    s.x += k * dx;
    s.y += k * dy;
    s.z += k * dz;
    addSquare(k, dx, dy, dz, s.moment);
    addSquare(m, dx, dy, dz, s.others);
  }
  /// Adds k d d^T.
  THAW_INLINE static void addSquare(L k, L dx, L dy, L dz, Tensor<L>& to) {
    const L x = k * dx, y = k * dy, z = k * dz;
    to.xx += x * dx;
    to.yy += y * dy;
    to.zz += z * dz;
    to.xy += x * dy;
    to.xz += x * dz;
    to.yz += y * dz;
  }
  THAW_INLINE static Sym3d laneOf(double k, const Tensor<L>& t, int l) {
    const auto at = [k, l](const L& v) { return k * static_cast<double>(v[l]); };
    return {at(t.xx), at(t.yy), at(t.zz), at(t.xy), at(t.yz), at(t.xz)};
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const double h = in->support, scale = in->relativeDensityScale * h * h;
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const std::uint32_t i = rows[l];
        in->impulse[i] = {scale * static_cast<double>(s.x[l]), scale * static_cast<double>(s.y[l]),
                          scale * static_cast<double>(s.z[l])};
        in->moment[i] = laneOf(-scale * h, s.moment, l);
        in->otherResponse[i] = laneOf(scale * scale, s.others, l);
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
