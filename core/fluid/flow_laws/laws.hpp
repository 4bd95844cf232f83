// SPDX-License-Identifier: Apache-2.0
// The table of flow laws. Scenes, documents, checks, restarts, steps and the apparent viscosity use it. To
// add a law: docs/developer/extend.md.
#pragma once
#include "core/fluid/flow_laws/bingham.hpp"
#include "core/fluid/flow_laws/carreau.hpp"
#include "core/fluid/flow_laws/herschel_bulkley.hpp"
#include "core/fluid/flow_laws/power_law.hpp"

namespace thaw {

/// In the order of the enumeration after Newtonian.
// clang-format off
inline constexpr const FlowLawRow* flowLawTable[] = {
    &binghamLaw,
    &herschelBulkleyLaw,
    &powerLaw,
    &carreauLaw};
// clang-format on

consteval bool flowLawsAreInOrder() {
  int place = 0;
  for (const FlowLawRow* row : flowLawTable)
    if (static_cast<int>(row->law) != ++place) return false;
  return true;
}
static_assert(flowLawsAreInOrder());

}  // namespace thaw
