// SPDX-License-Identifier: Apache-2.0
// Moves an earlier run in the folder of a new one aside.
#pragma once
#include <string>

namespace thaw {

inline constexpr const char* earlierRunFolder = "previous";

/// Returns whether the folder holds frames or checkpoints of a run.
bool holdsRun(const std::string& out);

/// Moves frames, checkpoints, pictures, logs and the summary of `out` to out/previous, and removes its old
/// content. Returns false if `out` holds no run. One process only. Throws IoError.
bool moveEarlierRunAside(const std::string& out);

}  // namespace thaw
