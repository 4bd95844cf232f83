// What of a run or a checkpoint fits on a screen: `thaw info` without --all.
#pragma once
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thaw {

/// Lines about the folder of a run, some 20 at most, from what describePath says of it: how far it is, what
/// it holds, the books, what happened, the first warnings.
std::vector<std::string> summaryOfRun(const nlohmann::ordered_json& run);

/// A checkpoint without the sums of its ledger, its fields, and counters that are 0.
nlohmann::ordered_json shortCheckpoint(nlohmann::ordered_json checkpoint);

}  // namespace thaw
