// SPDX-License-Identifier: Apache-2.0
// Options of a run, of `thaw run` and of a Simulation.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace thaw {

struct RunOptions {
  std::string scene = {};                   ///< scene file, or a name for messages
  std::string out = {};                     ///< folder of the run; empty: nothing is written
  std::vector<std::string> overrides = {};  ///< "key=value"
  long long steps = -1;    ///< stop when the run has this many steps; < 0: at the scene's end
  double timeLimit = 0;    ///< s of wall-clock time; 0: none
  bool restart = false;    ///< continue from the last checkpoint, which must be there
  bool resume = false;     ///< continue if there is a checkpoint, else start anew
  bool force = false;      ///< take over the folder from a run of another host
  std::int64_t relax = 0;  ///< smallest number of relaxation iterations for all oriented bodies; above 0, no
                           ///< step follows
  bool profile = false;    ///< phase table at the end, and a trace
  int traceSteps = 20;     ///< number of last steps in the trace
  bool history = false;    ///< keep the rows of the ledger in memory
  double reportEvery = 2;  ///< s of wall-clock time between progress lines
  std::function<void(const std::string&)> log = {};  ///< receives each line of progress, notes and warnings,
                                                     ///< on the first rank; none: the run is silent
  std::function<void(const std::string&)> status = {};  ///< receives a short status line in place of
                                                        ///< each progress line, for terminals
};

}  // namespace thaw
