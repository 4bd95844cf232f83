// Where the memory of a rank goes.
#pragma once
#include <string>
#include <vector>

#include "core/step.hpp"

namespace thaw {

struct MemoryUse {
  const char* what;
  double bytes;
};

/// Bytes that are allocated on this rank, by what they are for.
std::vector<MemoryUse> memoryOf(const World& world, const StepTools& tools);
double totalBytes(const std::vector<MemoryUse>& use);

/// Names of the fields that are allocated, "table.field", in their order: what a scene models.
std::vector<std::string> fieldsOf(const World& world);

}  // namespace thaw
