// SPDX-License-Identifier: Apache-2.0
#include "io/commands/view.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "io/frames/run_folder.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/text/command_error.hpp"
#include "io/view/page/page_file.hpp"
#include "io/view/server/serve.hpp"

namespace fs = std::filesystem;

namespace thaw {

void addViewOptions(CLI::App& command, ViewOptions& o) {
  command.add_option("run", o.run, "folder of a run, finished or running")->required();
  command.add_option("--port", o.port, "port on 127.0.0.1 (default: 8573, or a free one if that is taken)")
      ->check(CLI::Range(1, 65535));
  command.add_flag("!--no-open", o.open, "start no browser");
}

int viewCommand(const ViewOptions& options) {
  try {
    const fs::path run = runFolder(options.run);
    std::string problem = serverProblem();
    if (problem.empty()) problem = pageProblem();
    if (!problem.empty()) {
      printCommandError("view", problem);
      return exitUsage;
    }
    serveRun({run, options.port, options.open});
    return exitDone;
  } catch (const std::runtime_error& error) {  // IoError or a file system error
    printCommandError("view", error.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
