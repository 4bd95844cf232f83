// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

namespace thaw {

/// Returns the run's folder, which may be given by its frames/. Throws IoError if it is none.
std::filesystem::path runFolder(const std::filesystem::path& given);

}  // namespace thaw
