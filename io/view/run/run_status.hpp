// SPDX-License-Identifier: Apache-2.0
// State of a run from its lock, its summary and its progress log.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace thaw {

/// Returns `state` ("running", "done", "stopped", "failed", "killed", "unknown"), `text` for it, `live`,
/// whether a stop is requested, seconds since the last progress line, the last progress line by column, and
/// `summary`: the entries of summary.json except counters and times by phase. Missing and damaged files leave
/// their entries out.
nlohmann::ordered_json runStatus(const std::filesystem::path& run);

}  // namespace thaw
