// Requests from outside to stop: signals, a file named "stop" in the output folder, a limit of wall-clock
// time.
#pragma once
#include <chrono>
#include <string>

namespace thaw {

/// From now on SIGTERM, SIGINT, SIGUSR1 and SIGUSR2 only raise a flag (mpirun forwards the latter two and
/// leaves time; it kills the job two seconds after the former).
void catchSignals();

/// Number of the first signal caught, 0 if none.
int caughtSignal();

/// A reason to stop that this rank knows of, empty if none. The stop file is looked for at most twice a
/// second.
struct StopWatch {
  std::string stopFile;  ///< path
  double timeLimit = 0;  ///< s of wall-clock time, 0: none
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now(), looked{};
  std::string reason();
};

}  // namespace thaw
