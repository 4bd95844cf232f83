// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/rheology/laws/flow_law.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/materials/liquid_materials.hpp"

namespace thaw {
namespace {

enum class Scale { Linear, Logarithmic };

double valueAt(const TemperatureTable& t, double T, Scale scale) {
  if (t.empty()) return 0;
  if (T <= t.front().first || t.size() == 1) return t.front().second;
  for (std::size_t k = 1; k < t.size(); k++)
    if (T < t[k].first) {
      const double a = (T - t[k - 1].first) / (t[k].first - t[k - 1].first), low = t[k - 1].second,
                   high = t[k].second;
      return scale == Scale::Linear ? low + a * (high - low) : low * std::pow(high / low, a);
    }
  return t.back().second;
}

/// Calls action for the coefficients at each temperature of the tables. Between them both parameters are
/// monotonic.
template<class Action> void atTableEntries(const FlowLawSettings& s, double leastRate, Action action) {
  std::set<double> temperatures;
  for (const TemperatureTable* t : {&s.yieldStress, &s.consistency})
    for (const auto& point : *t) temperatures.insert(point.first);
  for (const double T : temperatures) action(flowCoefficients(s, leastRate, T));
}

}  // namespace

const char* nameOf(FlowLaw law) {
  switch (law) {
    case FlowLaw::Newtonian: return "Newtonian";
    case FlowLaw::Bingham: return "Bingham";
    case FlowLaw::HerschelBulkley: return "Herschel-Bulkley";
    case FlowLaw::PowerLaw: return "power law";
    case FlowLaw::Carreau: return "Carreau";
  }
  return "";
}

double leastRateOf(const Scene& s, const Material& m) {
  if (m.flowLaw.leastRate > 0) return m.flowLaw.leastRate;
  constexpr double slow = 1e-4, leastSpeed = 1e-3;  // 1; m/s, if nothing moves
  const Vec3d size = s.domain.max - s.domain.min;
  return slow * std::max(expectedSpeed(s), leastSpeed) / std::max({size.x, size.y, size.z});
}

double resolvedRate(const Scene& s) {
  constexpr double leastSpeed = 1e-3;  // m/s, if nothing moves
  return std::max(expectedSpeed(s), leastSpeed) / s.spacing;
}

FlowCoefficients flowCoefficients(const FlowLawSettings& s, double leastRate, double T) {
  return {s.law,
          valueAt(s.yieldStress, T, Scale::Linear),
          valueAt(s.consistency, T, Scale::Logarithmic),
          s.exponent,
          s.infiniteViscosity,
          s.relaxationTime,
          leastRate,
          s.largestViscosity > 0 ? s.largestViscosity : never};
}

double apparentViscosity(const FlowCoefficients& c, double rate) {
  const double half = 0.5 * (c.exponent - 1);
  if (c.law == FlowLaw::Carreau) {
    const double x = c.time * rate;
    return std::min(c.infinite + (c.viscosity - c.infinite) * std::pow(1 + x * x, half), c.largest);
  }
  const double e = c.leastRate,
               flow = c.exponent == 1 ? c.viscosity : c.viscosity * std::pow(rate * rate + e * e, half);
  // -expm1(-x) / x tends to 1.
  const double x = rate / e, yield = c.yieldStress / e * (x > 1e-8 ? -std::expm1(-x) / x : 1);
  return std::min(flow + yield, c.largest);
}

double largestFlowViscosity(const FlowLawSettings& s, double leastRate, double largestRate) {
  double largest = 0;
  atTableEntries(s, leastRate, [&](const FlowCoefficients& c) {
    largest = std::max({largest, apparentViscosity(c, 0), apparentViscosity(c, largestRate)});
  });
  return largest;
}

double leastFlowViscosity(const FlowLawSettings& s, double leastRate, double largestRate) {
  double least = never;
  atTableEntries(s, leastRate, [&](const FlowCoefficients& c) {
    least = std::min({least, apparentViscosity(c, 0), apparentViscosity(c, largestRate)});
  });
  return least;
}

}  // namespace thaw
