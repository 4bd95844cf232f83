// SPDX-License-Identifier: Apache-2.0
// The only file that `thaw view` writes: `stop` in the folder of a live run.
#pragma once
#include <filesystem>
#include <string>

namespace thaw {

inline constexpr const char* stopName = "stop";

/// Returns whether a run may be live in this folder. Its lock then names an existing process of this host, or
/// a process of another host.
bool mayBeLive(const std::filesystem::path& run);

/// Creates the stop file, which ends the run (io/run/signals.hpp). Returns why this is not possible, or "".
/// An existing file is left as it is.
std::string requestStop(const std::filesystem::path& run);

}  // namespace thaw
