// SPDX-License-Identifier: Apache-2.0
// Work data of heat flows, reused in each step. It is not part of the state.
#pragma once
#include "core/heat/conduction_correction.hpp"
#include "core/heat/contact_heat.hpp"

namespace thaw {

struct HeatWork {
  ContactHeatWork contact;
  ConductionWork conduction;
};

}  // namespace thaw
