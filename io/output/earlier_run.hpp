// A new run in a folder that holds one: what is there is set aside, not lost.
#pragma once
#include <string>

namespace thaw {

inline constexpr const char* earlierRunFolder = "previous";

/// Does the folder hold frames or checkpoints of a run?
bool holdsRun(const std::string& out);

/// Moves frames, checkpoints, pictures and the summary of `out` into out/previous, in place of what was
/// there. False where there was no run. On one rank. Throws IoError.
bool setAsideEarlierRun(const std::string& out);

}  // namespace thaw
