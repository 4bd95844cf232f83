// SPDX-License-Identifier: Apache-2.0
// Version of the program, for frames, checkpoints, summaries and --version.
#pragma once

namespace thaw {

/// Returns the version number, such as "0.2.0".
const char* versionNumber();
/// Returns the commit of the source, with "+" behind it if files differed, or "unknown" outside a git
/// checkout.
const char* versionCommit();

}  // namespace thaw
