// SPDX-License-Identifier: Apache-2.0
#include "io/commands/view.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>

#include "io/hdf5/io_error.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/view/page/page_file.hpp"
#include "io/view/server/serve.hpp"

namespace fs = std::filesystem;

namespace thaw {

fs::path runFolder(const fs::path& given) {
  std::error_code error;
  fs::path folder = fs::canonical(given, error);
  if (error || !fs::is_directory(folder)) throw IoError(given.string(), "there is no such folder");
  if (folder.filename() == "frames") folder = folder.parent_path();
  constexpr std::array<const char*, 4> signs{"frames", "summary.json", "progress.csv", "lock"};
  if (std::none_of(signs.begin(), signs.end(), [&](const char* name) { return fs::exists(folder / name); }))
    throw IoError(given.string(), "is not a run folder: it has no frames and no summary.json");
  return folder;
}

void addViewOptions(CLI::App& command, ViewOptions& o) {
  command.add_option("run", o.run, "folder of a run, finished or running")->required();
  command.add_option("--port", o.port, "port on 127.0.0.1 (default: 8573, or a free one if that is taken)")
      ->check(CLI::Range(1, 65535));
  command.add_flag("!--no-open", o.open, "start no browser");
}

int viewCommand(const ViewOptions& options) {
  std::string problem = serverProblem();
  if (problem.empty()) problem = pageProblem();
  if (!problem.empty()) {
    fmt::print(stderr, "thaw view: {}\n", problem);
    return exitUsage;
  }
  try {
    serveRun({runFolder(options.run), options.port, options.open});
    return exitDone;
  } catch (const std::runtime_error& error) {  // IoError or a file system error
    fmt::print(stderr, "thaw view: {}\n", error.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
