// SPDX-License-Identifier: Apache-2.0
#include "io/frames/run_folder.hpp"

#include <algorithm>
#include <array>

#include "io/hdf5/io_error.hpp"

namespace fs = std::filesystem;

namespace thaw {

fs::path runFolder(const fs::path& given) {
  std::error_code error;
  fs::path folder = fs::canonical(given, error);
  if (error) throw IoError(given.string(), "no such folder");
  if (!fs::is_directory(folder)) throw IoError(given.string(), "is a file: a page needs the folder of a run");
  if (folder.filename() == "frames") folder = folder.parent_path();
  constexpr std::array<const char*, 4> signs{"frames", "summary.json", "progress.csv", "lock"};
  if (std::none_of(signs.begin(), signs.end(), [&](const char* name) { return fs::exists(folder / name); }))
    throw IoError(given.string(),
                  "is not a run folder: expected a folder with frames/, summary.json, progress.csv or lock");
  return folder;
}

}  // namespace thaw
