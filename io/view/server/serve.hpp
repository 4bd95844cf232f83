// SPDX-License-Identifier: Apache-2.0
// The HTTP server of `thaw view`.
#pragma once
#include <filesystem>
#include <string>

namespace thaw {

struct ServeOptions {
  std::filesystem::path run;
  int port = 0;      ///< 0: the usual one, or a free one if that is taken
  bool open = true;  ///< start a browser where there is a desktop
};

/// Returns why there is no server in this program and how to get it, or "".
std::string serverProblem();

/// Serves a run on the loopback interface until SIGINT or SIGTERM. Prints the address. Throws IoError if the
/// port cannot be used. Requires: serverProblem() is empty.
void serveRun(const ServeOptions& options);

}  // namespace thaw
