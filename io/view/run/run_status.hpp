// SPDX-License-Identifier: Apache-2.0
// State of a run from its lock, its summary and its progress log.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace thaw {

/// Returns `state` ("running", "done", "stopped", "failed", "refused", "killed", "unknown"), `text` for it,
/// `live`, and whether a stop is requested. Also the seconds since the last progress line, and that line by
/// column. `summary` has the entries of summary.json except counters and times by phase. Missing and damaged
/// files leave their entries out.
nlohmann::ordered_json runStatus(const std::filesystem::path& run);

}  // namespace thaw
