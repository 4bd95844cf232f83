// Which thaw this is: in frames, checkpoints, summaries and --version.
#pragma once

namespace thaw {

/// Version number, as "0.1.0".
const char* versionNumber();
/// Commit the program was built from, with "+" behind it if files differed from the commit; "unknown" outside
/// a git checkout.
const char* versionCommit();

}  // namespace thaw
