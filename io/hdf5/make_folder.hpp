// SPDX-License-Identifier: Apache-2.0
// Folders for output.
#pragma once
#include <filesystem>

namespace thaw {

/// Makes a folder and those above it, unless they exist; "" is the current one. Throws IoError with folder
/// and cause.
void makeFolder(const std::filesystem::path& folder);

}  // namespace thaw
