// thaw run SCENE: simulate.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thaw {

struct RunOptions {
  std::string scene, out;
  std::vector<std::string> overrides;
  long long steps = -1;    ///< stop after this many steps in all; < 0: at the scene's end
  double timeLimit = 0;    ///< s of wall-clock time; 0: none
  bool restart = false;    ///< continue from the last checkpoint, which must be there
  bool resume = false;     ///< continue if there is a checkpoint, else begin
  bool force = false;      ///< take the folder from a run of another host
  std::int64_t relax = 0;  ///< iterations of relaxation for all oriented bodies, at least; above 0, nothing
                           ///< else is done
  bool profile = false;    ///< phase table at the end, and a trace
  int traceSteps = 20;     ///< steps at the end that the trace shows
  double reportEvery = 2;  ///< s of wall-clock time between progress lines
};

/// Options of `thaw relax`: of run, those that fit.
void addRelaxOptions(CLI::App& command, RunOptions& options);

void addRunOptions(CLI::App& command, RunOptions& options);

/// All ranks; MPI is initialised. Returns the exit code: 0 done, 2 bad scene, 3 input or output, 4 blew up,
/// 75 stopped with a checkpoint.
int runCommand(const RunOptions& options);

}  // namespace thaw
