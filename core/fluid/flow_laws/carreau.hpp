// SPDX-License-Identifier: Apache-2.0
// Carreau's liquid [C72]: mu_inf + (mu_0 - mu_inf) (1 + (lambda g)^2)^((n-1)/2).
#pragma once
#include <cmath>

#include "core/fluid/flow_laws/yield.hpp"

namespace thaw {

inline constexpr FlowLawKey carreauKeys[] = {
    viscosityKey,
    exponentKey,
    {"infinite_viscosity", false,
     [](KeyTable& keys, const char* name, FlowLawSettings& f) {
       keys.number(name, f.infiniteViscosity, "Pa s", notNegative(),
                   "viscosity of carreau at high shear rates");
     }},
    {"relaxation_time", true, [](KeyTable& keys, const char* name, FlowLawSettings& f) {
       keys.number(name, f.relaxationTime, "s", notNegative(),
                   "carreau: inverse of the shear rate at which thinning begins");
     }}};

inline double carreauViscosity(const FlowCoefficients& c, double rate) {
  const FlowLawSettings& s = *c.settings;
  const double x = s.relaxationTime * rate;
  return s.infiniteViscosity +
         (c.viscosity - s.infiniteViscosity) * std::pow(1 + x * x, 0.5 * (s.exponent - 1));
}

inline constexpr FlowLawRow carreauLaw{
    .law = FlowLaw::Carreau,
    .name = "carreau",
    .title = "Carreau",
    .stress = "the viscosity falls from `viscosity` to `infinite_viscosity`",
    .keys = carreauKeys,
    .viscosity = carreauViscosity,
    .steepness = powerSteepness};

}  // namespace thaw
