// SPDX-License-Identifier: Apache-2.0
// `thaw check SCENE`: reports what would be simulated.
#pragma once
#include <mpi.h>

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thaw {

struct CheckOptions {
  std::string scene;
  std::vector<std::string> overrides;
  int ranks = 0;          ///< number of ranks for the estimates; 0: the ranks of this command
  bool json = false;      ///< print the report, or the errors of the scene, as JSON
  bool settings = false;  ///< print all settings on the frontier of error against time
};

void addCheckOptions(CLI::App& command, CheckOptions& options);

/// Returns the report of the scene, or its errors, as JSON. Collective over `comm`.
std::string checkJson(const CheckOptions& options, MPI_Comm comm);

/// Samples the bodies and prints a report. It has particles per body, memory, modules with their reasons, the
/// time step with its limit, and the estimated run time. Returns the exit code.
int checkCommand(const CheckOptions& options);

}  // namespace thaw
