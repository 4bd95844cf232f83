// SPDX-License-Identifier: Apache-2.0
// Files of a run that `thaw view` reads.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace thaw {

/// Returns the path of a file below the run's folder. Returns nothing if it is missing, no regular file, or
/// leads out of the folder by "..", an absolute path or a link.
std::optional<std::filesystem::path> fileInRun(const std::filesystem::path& run,
                                               const std::filesystem::path& relative);

/// Returns the path of a CSV file of a run (ledger.csv, progress.csv, surface.csv, events.csv), or nothing
/// for all other names.
std::optional<std::filesystem::path> logInRun(const std::filesystem::path& run, const std::string& name);

}  // namespace thaw
