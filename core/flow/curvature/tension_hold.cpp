// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/tension_hold.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/materials/liquid_materials.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/phase_density.hpp"

namespace thaw {
namespace {

/// Returns the smallest viscosity (Pa s) of the liquid.
double leastViscosity(const Material& m) {
  if (hasFlowLaw(m)) return 0;
  double least = m.viscosityTable.empty() ? m.viscosity.liquid : never;
  for (const auto& point : m.viscosityTable) least = std::min(least, point.second);
  return least;
}

double largestTensionOf(const Material& m) {
  return m.surfaceTensionTable.empty() ? m.surfaceTension : largestTension(m.surfaceTensionTable);
}

}  // namespace

double tensionHold(const Scene& s) {
  const Numerics& n = s.numerics;
  const double h = n.support * s.spacing;
  double hold = never;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    const double tension = largestTensionOf(m);
    if (!inUse(s, k) || !canBeLiquid(m) || !(tension > 0)) continue;
    const double limit = n.cflTension *
                         std::sqrt(leastDensityOf(m) * h * h * h / (2 * std::numbers::pi * tension));
    hold = std::min({hold, 0.1 * limit, 0.25 * leastViscosity(m) * s.spacing / tension});
  }
  return hold < never ? hold : 0;
}

bool isTensionDue(double hold, const Clock& clock, double dt) {
  const double fitting = clock.dt > 0 ? std::min(hold / clock.dt, 64.0) : 0;
  const auto steps = static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(fitting)));
  return dt == 0 || steps <= 1 || clock.step % steps == 0;
}

}  // namespace thaw
