// SPDX-License-Identifier: Apache-2.0
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

double FactorInTime::mean(double from, double to) const {
  if (linear(from, to)) return 0.5 * (at(from) + at(to));
  double sum = 0;
  // Adds the part of a linear piece between the two times.
  const auto add = [&](double t0, double f0, double t1, double f1) {
    const double begin = std::max(t0, from), end = std::min(t1, to);
    if (!(begin < end)) return;
    const auto value = [&](double t) { return f0 == f1 ? f0 : f0 + (f1 - f0) * ((t - t0) / (t1 - t0)); };
    sum += 0.5 * (value(begin) + value(end)) * (end - begin);
  };
  add(from, points.front().second, points.front().first, points.front().second);
  for (std::size_t k = 1; k < points.size(); k++)
    add(points[k - 1].first, points[k - 1].second, points[k].first, points[k].second);
  add(points.back().first, points.back().second, to, points.back().second);
  return sum / (to - from);
}

bool FactorInTime::linear(double from, double to) const {
  return std::none_of(points.begin(), points.end(),
                      [&](const auto& p) { return p.first > from && p.first < to; });
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
