// SPDX-License-Identifier: Apache-2.0
#include "core/scene/temperature_table.hpp"

#include <cmath>

namespace thaw {

double valueAt(const TemperatureTable& t, double T, Interpolation between) {
  if (T <= t.front().first) return t.front().second;
  for (std::size_t k = 1; k < t.size(); k++)
    if (T < t[k].first) {
      const double a = (T - t[k - 1].first) / (t[k].first - t[k - 1].first), low = t[k - 1].second,
                   high = t[k].second;
      return between == Interpolation::Linear ? low + a * (high - low) : low * std::pow(high / low, a);
    }
  return t.back().second;
}

}  // namespace thaw
