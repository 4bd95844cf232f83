// SPDX-License-Identifier: Apache-2.0
#include "core/heat/mush.hpp"

#include <cmath>

#include "core/kernels/with_kernel.hpp"

namespace thaw {

double mushRateOf(const Material& m, double f) {
  constexpr double leastPermeable = 1e-3;  // b of VP87
  return m.mushDrag * (1 - f) * (1 - f) / ((f * f * f + leastPermeable) * m.density);
}

void findMush(const HeatView& v, const CellGrid& grid, const NeighbourLists& lists) {
  const Scene& s = v.scene;
  Continuum& p = v.particles;
  std::fill_n(p.mushRate.data(), p.owned, 0.0f);
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || p.phase[i] != Liquid) continue;
      const Material& m = s.materials[p.material[i]];
      const double f = static_cast<double>(p.liquid[i]);
      if (!(m.mushDrag > 0) || f >= 1 || (p.clamped.active && p.clamped[i])) continue;
      Vec3d sum{};
      double weight = 0;
      for (std::uint32_t k = 0; k < lists.count[g]; k++) {
        const std::uint32_t j = lists.row(g, k, l);
        if (j == lists.dummy || p.phase[j] != Solid) continue;
        const Vec3d d = (p.position[i] - p.position[j]) / grid.support;
        const double q2 = dot(d, d);
        if (q2 >= 1) continue;
        const double w = p.mass[j] * withKernel(s.numerics.kernel, [&](auto kernel) { return kernel.w(q2); });
        sum += p.velocity[j] * w;
        weight += w;
      }
      if (!(weight > 0)) continue;
      p.mushRate[i] = static_cast<float>(mushRateOf(m, f));
      p.solidVelocity[i] = sum * (1 / weight);
    }
}

void applyMush(const HeatView& v, double span, double drift) {
  Continuum& p = v.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double rate = static_cast<double>(p.mushRate[i]);
    if (!(rate > 0) || p.phase[i] != Liquid) continue;
    const Vec3d solid = p.solidVelocity[i], before = p.velocity[i],
                change = (before - solid) * std::expm1(-rate * span), impulse = p.mass[i] * change;
    p.velocity[i] = before + change;
    p.position[i] += change * drift;
    const double work = dot(impulse, solid);
    p.dissipated[i] += work - dot(impulse, before + 0.5 * change);
    if (work != 0) v.ledger.wallWork.add(work);
    for (int a = 0; a < 3; a++) v.ledger.wallImpulse[a].add(impulse[a]);
  }
}

}  // namespace thaw
