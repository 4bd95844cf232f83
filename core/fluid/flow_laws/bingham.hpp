// SPDX-License-Identifier: Apache-2.0
// Bingham's liquid [B22].
#pragma once
#include "core/fluid/flow_laws/yield.hpp"

namespace thaw {

inline constexpr FlowLawKey binghamKeys[] = {yieldStressKey, viscosityKey, leastRateKey};

inline constexpr FlowLawRow binghamLaw{
    .law = FlowLaw::Bingham,
    .name = "bingham",
    .title = "Bingham",
    .stress = "yield_stress + viscosity g",
    .keys = binghamKeys,
    .viscosity = [](const FlowCoefficients& c, double rate) { return c.viscosity + yieldViscosity(c, rate); },
    .steepness = [](const FlowLawSettings&) { return 1.0; }};

}  // namespace thaw
