// SPDX-License-Identifier: Apache-2.0
// Memory use of a rank.
#pragma once
#include <string>
#include <vector>

#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct MemoryUse {
  const char* what;
  double bytes;
};

/// Returns the allocated bytes of this rank by purpose.
std::vector<MemoryUse> memoryOf(const World& world, const StepTools& tools);
double totalBytes(const std::vector<MemoryUse>& use);

/// Returns the names of the allocated fields, "table.field", in order.
std::vector<std::string> fieldsOf(const World& world);

}  // namespace thaw
