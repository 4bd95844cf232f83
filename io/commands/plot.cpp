// SPDX-License-Identifier: Apache-2.0
#include "io/commands/plot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/commands/plot_script.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/hdf5/make_folder.hpp"
#include "io/text/command_error.hpp"
#include "io/text/png_name.hpp"
#include "io/text/shell_word.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

/// Returns the first interpreter that has matplotlib, which the python3 on PATH may lack. Throws IoError.
std::string findPython() {
  std::vector<std::string> candidates{"python3", "/usr/bin/python3"};
  if (const char* given = std::getenv("THAW_PYTHON")) candidates = {given};
  std::string names;
  for (const std::string& python : candidates) {
    if (std::system((shellWord(python) + " -c 'import matplotlib, numpy' >/dev/null 2>&1").c_str()) == 0)
      return python;
    names += (names.empty() ? "" : " and ") + python;
  }
  throw IoError("thaw plot",
                fmt::format("needs python3 with matplotlib and numpy (Debian: apt-get install "
                            "python3-matplotlib); tried {}; set THAW_PYTHON to use another interpreter",
                            names));
}

void draw(const PlotOptions& o) {
  std::error_code error;
  if (!fs::is_directory(o.run, error))
    throw IoError(o.run.string(),
                  fs::exists(o.run, error) ? "is a file: expected the folder of a run" : "no such folder");
  const fs::path picture = o.out.empty() ? o.run / "pictures" / "plot.png" : o.out;
  const std::string python = findPython();
  makeFolder(picture.parent_path());
  const std::string command = fmt::format("{} - {} {}", shellWord(python), shellWord(o.run.string()),
                                          shellWord(picture.string()));
  auto* const before = std::signal(SIGPIPE, SIG_IGN);
  std::FILE* const pipe = ::popen(command.c_str(), "w");
  if (!pipe) throw IoError(python, "cannot be started");
  std::fwrite(plotScript().data(), 1, plotScript().size(), pipe);
  const int status = ::pclose(pipe);
  std::signal(SIGPIPE, before);
  if (status != 0)
    throw IoError(o.run.string(), fmt::format("no picture: {} ended with exit code {}", python,
                                              WIFEXITED(status) ? WEXITSTATUS(status) : 128));
}

}  // namespace

CLI::App* addPlotCommand(CLI::App& app, PlotOptions& o) {
  CLI::App* c = app.add_subcommand(
      "plot", "draw energies, heat, front, time step and phases of a run; needs python3 with matplotlib");
  c->add_option("run", o.run, "folder of a run, finished or running")->required();
  c->add_option("--out", o.out, "picture (PNG) (default: pictures/plot.png in the run's folder)")
      ->check(pngName());
  return c;
}

int plotCommand(const PlotOptions& o) {
  try {
    draw(o);
    return 0;
  } catch (const std::runtime_error& e) {
    printCommandError("plot", e.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
