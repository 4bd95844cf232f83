// SPDX-License-Identifier: Apache-2.0
// Surface tension as pair cohesion. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/laws/cohesion.hpp"
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class Real> struct Tension {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *surface;
  const PairSums* in;
  double scale;  // 8 / (pi moment4), with units applied in finish
  struct Data {
    Lanes4<Real> positionVolume, surface;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0), energy = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(surface, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L q = min(sqrt(dx * dx + dy * dy + dz * dz), L(1.0));
    const L strength = j.positionVolume.d * j.surface.a;
    const L f = strength * Cohesion::force(q) / max(q, L(1e-6));
    s.x -= f * dx;
    s.y -= f * dy;
    s.z -= f * dz;
    s.energy += strength * Cohesion::potential(q);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double own = scale * static_cast<double>(i.positionVolume.d[l]) *
                           static_cast<double>(i.surface.a[l]);
        Vec3d& f = in->force[rows[l]];
        f.x += own * in->support * static_cast<double>(s.x[l]);
        f.y += own * in->support * static_cast<double>(s.y[l]);
        f.z += own * in->support * static_cast<double>(s.z[l]);
        in->interaction[rows[l]] += 0.5 * own * in->support * in->support * static_cast<double>(s.energy[l]);
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
