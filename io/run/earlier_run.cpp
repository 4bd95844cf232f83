// SPDX-License-Identifier: Apache-2.0
#include "io/run/earlier_run.hpp"

#include <filesystem>

#include "io/hdf5/io_error.hpp"

namespace thaw {
namespace fs = std::filesystem;

bool holdsRun(const std::string& out) {
  std::error_code error;
  const auto filled = [&](const char* folder) {
    return fs::exists(out + "/" + folder, error) && !fs::is_empty(out + "/" + folder, error);
  };
  return filled("frames") || filled("checkpoint");
}

bool moveEarlierRunAside(const std::string& out) {
  if (!holdsRun(out)) return false;
  std::error_code error;
  const std::string aside = out + "/" + earlierRunFolder;
  fs::remove_all(aside, error);
  fs::create_directories(aside, error);
  if (error) throw IoError(aside, "cannot be made: " + error.message());
  for (const char* name : {"frames", "checkpoint", "pictures", "summary.json", "warnings.json", "surface.csv",
                           "events.csv", "progress.csv", "ledger.csv"}) {
    if (!fs::exists(out + "/" + name, error)) continue;
    fs::rename(out + "/" + name, aside + "/" + name, error);
    if (error) throw IoError(out + "/" + name, "cannot be moved to " + aside + ": " + error.message());
  }
  return true;
}

}  // namespace thaw
