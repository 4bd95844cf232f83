// SPDX-License-Identifier: Apache-2.0
// CSV files of a run whose rows begin with a step.
#pragma once
#include <cstdint>
#include <string>

namespace thaw {

/// Removes the rows after `step`. Begins a new file with the line `head` if the present one has another first
/// line.
void truncateStepLog(const std::string& path, const std::string& head, std::int64_t step);

}  // namespace thaw
