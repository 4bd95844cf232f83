// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

namespace thaw {

/// Returns the run folder; `given` is the folder or its frames/. Throws IoError if it is not a run folder.
std::filesystem::path runFolder(const std::filesystem::path& given);

}  // namespace thaw
