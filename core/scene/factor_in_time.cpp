#include "core/scene/factor_in_time.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

double FactorInTime::at(double time) const {
  if (points.empty()) return 1;
  if (time <= points.front().first) return points.front().second;
  for (std::size_t k = 1; k < points.size(); k++)
    if (time < points[k].first) {
      const auto& [t0, f0] = points[k - 1];
      const auto& [t1, f1] = points[k];
      return f0 + (f1 - f0) * ((time - t0) / (t1 - t0));
    }
  return points.back().second;
}

double FactorInTime::least(double from, double to) const {
  double least = std::min(at(from), at(to));
  for (const auto& [time, factor] : points)
    if (time > from && time < to) least = std::min(least, factor);
  return least;
}

double FactorInTime::most(double from, double to) const {
  double most = std::max(std::abs(at(from)), std::abs(at(to)));
  for (const auto& [time, factor] : points)
    if (time > from && time < to) most = std::max(most, std::abs(factor));
  return most;
}

}  // namespace thaw
