// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/tension_interval.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/materials/liquid_materials.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/material_use.hpp"

namespace thaw {
namespace {

/// Returns the smallest viscosity (Pa s) of the liquid.
double leastViscosity(const Material& m) {
  if (hasFlowLaw(m)) return 0;
  double least = m.viscosityTable.empty() ? m.viscosity.liquid : never;
  for (const auto& point : m.viscosityTable) least = std::min(least, point.second);
  return least;
}

}  // namespace

double tensionInterval(const Scene& s) {
  const Numerics& n = s.numerics;
  double interval = never;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    const double tension = m.surfaceTension;
    if (!inUse(s, k) || !canBeLiquid(m) || !(tension > 0)) continue;
    interval = std::min({interval, 0.1 * (n.cflTension * capillaryTime(s, m)),
                         0.25 * leastViscosity(m) * s.spacing / tension});
  }
  return interval < never ? interval : 0;
}

bool isTensionDue(double interval, const Clock& clock, double dt) {
  const double fitting = clock.dt > 0 ? std::min(interval / clock.dt, 64.0) : 0;
  const auto steps = static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(fitting)));
  return dt == 0 || steps <= 1 || clock.step % steps == 0;
}

}  // namespace thaw
