// SPDX-License-Identifier: Apache-2.0
#include "core/materials/surface_tension.hpp"

#include <algorithm>

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

}  // namespace thaw
