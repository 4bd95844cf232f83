// SPDX-License-Identifier: Apache-2.0
// Herschel and Bulkley's liquid [HB26].
#pragma once
#include "core/fluid/flow_laws/yield.hpp"

namespace thaw {

inline constexpr FlowLawKey herschelBulkleyKeys[] = {yieldStressKey, viscosityKey, exponentKey, leastRateKey};

inline constexpr FlowLawRow herschelBulkleyLaw{
    .law = FlowLaw::HerschelBulkley,
    .name = "herschel_bulkley",
    .title = "Herschel-Bulkley",
    .stress = "yield_stress + viscosity g^n with n = exponent and g in 1/s",
    .keys = herschelBulkleyKeys,
    .viscosity = [](const FlowCoefficients& c,
                    double rate) { return powerViscosity(c, rate) + yieldViscosity(c, rate); },
    .steepness = powerSteepness};

}  // namespace thaw
