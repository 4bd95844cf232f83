// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/flow_laws/flow_law.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/materials/liquid_materials.hpp"
#include "core/scene/temperature_table.hpp"

namespace thaw {
namespace {

/// Speed (m/s) by which shear rates are judged; at least a small one, if nothing moves.
double flowSpeed(const Scene& s) { return std::max(expectedSpeed(s), 1e-3); }

double valueOrZero(const TemperatureTable& t, double T, Interpolation between) {
  return t.empty() ? 0 : valueAt(t, T, between);
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
  constexpr double slow = 1e-4;
  const Vec3d size = s.domain.max - s.domain.min;
  return slow * flowSpeed(s) / std::max({size.x, size.y, size.z});
}

double resolvedRate(const Scene& s) { return flowSpeed(s) / s.spacing; }

FlowCoefficients flowCoefficients(const FlowLawSettings& s, double leastRate, double T) {
  return {s.law,
          valueOrZero(s.yieldStress, T, Interpolation::Linear),
          valueOrZero(s.consistency, T, Interpolation::Logarithmic),
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

double largestFlowViscosity(const Scene& s, const Material& m) {
  return largestFlowViscosity(m.flowLaw, leastRateOf(s, m), resolvedRate(s));
}

double leastFlowViscosity(const Scene& s, const Material& m) {
  return leastFlowViscosity(m.flowLaw, leastRateOf(s, m), resolvedRate(s));
}

}  // namespace thaw
