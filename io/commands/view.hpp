// SPDX-License-Identifier: Apache-2.0
// `thaw view RUN`: a page in the browser that shows a run, finished or running.
#pragma once
#include <filesystem>

namespace CLI {
class App;
}

namespace thaw {

struct ViewOptions {
  std::filesystem::path run;  ///< folder
  int port = 0;               ///< 0: the usual one, or a free one
  bool open = true;           ///< start a browser where there is a desktop
};

void addViewOptions(CLI::App& command, ViewOptions& options);

/// Serves the page until a signal. Returns the exit code: 0, 2 if the program is built without the page, 3
/// for a folder or a port that cannot be used.
int viewCommand(const ViewOptions& options);

}  // namespace thaw
