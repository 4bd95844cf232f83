// SPDX-License-Identifier: Apache-2.0
// `thaw plot RUN`: a picture of energies, heat, front, time step and phases of a run.
#pragma once
#include <filesystem>

namespace CLI {
class App;
}

namespace thaw {

struct PlotOptions {
  std::filesystem::path run;  ///< folder, finished or running
  std::filesystem::path out;  ///< picture; empty: pictures/plot.png in the folder
};

/// Adds the command. Returns it.
CLI::App* addPlotCommand(CLI::App& app, PlotOptions& options);

/// Starts python3 with matplotlib, which draws. Returns the exit code: 0, or 3 with a message.
int plotCommand(const PlotOptions& options);

}  // namespace thaw
