// SPDX-License-Identifier: Apache-2.0
// Terms of laws with a yield stress or a power of the rate, regularised at the least rate e.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/fluid/flow_laws/flow_law_row.hpp"

namespace thaw {

/// tau_y (1 - exp(-g/e)) / g at a shear rate g, Pa s [P87].
inline double yieldViscosity(const FlowCoefficients& c, double rate) {
  const double x = rate / c.leastRate;
  return c.yieldStress / c.leastRate * (x > 1e-8 ? -std::expm1(-x) / x : 1);  // the factor tends to 1
}

/// K (g^2 + e^2)^((n-1)/2), Pa s.
inline double powerViscosity(const FlowCoefficients& c, double rate) {
  const double n = c.settings->exponent, e = c.leastRate;
  return n == 1 ? c.viscosity : c.viscosity * std::pow(rate * rate + e * e, 0.5 * (n - 1));
}

/// Steepness (FlowLawRow::steepness) of laws whose stress grows at most as g^n.
inline double powerSteepness(const FlowLawSettings& s) { return std::max(s.exponent, 1.0); }

}  // namespace thaw
