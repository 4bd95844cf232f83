// SPDX-License-Identifier: Apache-2.0
// Ostwald and de Waele's power law.
#pragma once
#include "core/fluid/flow_laws/yield.hpp"

namespace thaw {

inline constexpr FlowLawKey powerLawKeys[] = {viscosityKey, exponentKey, leastRateKey};

inline constexpr FlowLawRow powerLaw{.law = FlowLaw::PowerLaw,
                                     .name = "power_law",
                                     .title = "power law",
                                     .stress = "the same without yield stress",
                                     .keys = powerLawKeys,
                                     .viscosity = powerViscosity,
                                     .steepness = powerSteepness};

}  // namespace thaw
