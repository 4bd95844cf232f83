// SPDX-License-Identifier: Apache-2.0
// Summaries of a run or a checkpoint for a screen: `thaw info` without --all.
#pragma once
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thaw {

/// Returns some 20 lines at most on a run folder, from the result of describePath: progress, content, ledger,
/// counters and the first warnings.
std::vector<std::string> summaryOfRun(const nlohmann::ordered_json& run);

/// Returns a checkpoint without the sums of its ledger, its fields, and counters that are 0.
nlohmann::ordered_json shortCheckpoint(nlohmann::ordered_json checkpoint);

}  // namespace thaw
