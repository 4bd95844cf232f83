// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/make_folder.hpp"

#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace fs = std::filesystem;

void makeFolder(const fs::path& folder) {
  std::error_code error;
  for (fs::path there = folder; !there.empty(); there = there.parent_path()) {
    if (fs::exists(there, error) && !fs::is_directory(there, error))
      throw IoError(there.string(), "is a file: expected a folder");
    if (there == there.parent_path()) break;  // the root
  }
  if (folder.empty() || fs::is_directory(folder, error)) return;
  if (!fs::create_directories(folder, error) && error)
    throw IoError(folder.string(), "cannot be created: " + error.message());
}

}  // namespace thaw
