// SPDX-License-Identifier: Apache-2.0
// `thaw run SCENE`: simulates a scene.
#pragma once
#include "io/run/run_options.hpp"

namespace CLI {
class App;
}

namespace thaw {

/// Adds the options of `thaw relax`, which are some of those of `thaw run`.
void addRelaxOptions(CLI::App& command, RunOptions& options);

void addRunOptions(CLI::App& command, RunOptions& options);

/// Runs on all ranks. Returns the exit code: 0 done, 2 invalid scene, 3 input or output failed, 4 simulation
/// failed, 75 stopped with a checkpoint. Requires: MPI is initialised.
int runCommand(const RunOptions& options);

}  // namespace thaw
