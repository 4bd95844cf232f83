// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/run_files.hpp"

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace thaw {

std::optional<fs::path> fileInRun(const fs::path& run, const fs::path& relative) {
  if (relative.empty() || relative.is_absolute()) return std::nullopt;
  if (std::any_of(relative.begin(), relative.end(), [](const fs::path& part) { return part == ".."; }))
    return std::nullopt;
  std::error_code error;
  const fs::path folder = fs::canonical(run, error);
  if (error) return std::nullopt;
  const fs::path file = fs::canonical(folder / relative, error);  // follows links
  if (error || !fs::is_regular_file(file, error)) return std::nullopt;
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() ? std::optional(file) : std::nullopt;
}

std::optional<fs::path> logInRun(const fs::path& run, const std::string& name) {
  constexpr std::array<const char*, 4> logs{"ledger.csv", "progress.csv", "surface.csv", "events.csv"};
  if (std::find(logs.begin(), logs.end(), name) == logs.end()) return std::nullopt;
  return fileInRun(run, name);
}

}  // namespace thaw
