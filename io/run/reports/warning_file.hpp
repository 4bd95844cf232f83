// SPDX-License-Identifier: Apache-2.0
// OUT/warnings.json: the warnings of a run in progress. It is written when they change, so a page that shows
// the run has them before the next summary.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaw {

inline constexpr const char* warningsName = "warnings.json";

/// Replaces OUT/warnings.json: an array of texts. One process only. Throws IoError.
void writeWarnings(const std::string& out, const std::vector<std::string>& warnings);

}  // namespace thaw
