// SPDX-License-Identifier: Apache-2.0
#include "core/materials/surface_tension.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/phase_density.hpp"
#include "core/scene/temperature_table.hpp"

namespace thaw {

double surfaceTensionAt(const Material& m, double temperature) {
  if (m.surfaceTensionTable.empty()) return m.surfaceTension;
  return valueAt(m.surfaceTensionTable, temperature, Interpolation::Linear);
}

double largestTension(const TemperatureTable& table) {
  double largest = 0;
  for (const auto& [temperature, tension] : table) largest = std::max(largest, tension);
  return largest;
}

double capillaryTime(const Scene& s, const Material& m) {
  const double h = s.numerics.support * s.spacing;
  return std::sqrt(leastDensityOf(m) * (h * h * h) / (2 * std::numbers::pi * m.surfaceTension));
}

}  // namespace thaw
