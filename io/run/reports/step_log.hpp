// SPDX-License-Identifier: Apache-2.0
// CSV files of a run whose rows begin with a step.
#pragma once
#include <cstdint>
#include <string>

namespace thaw {

/// Drops the rows of steps beyond `step`. Starts the file anew with `head` (a line) if it does not begin with
/// that.
void truncateStepLog(const std::string& path, const std::string& head, std::int64_t step);

}  // namespace thaw
