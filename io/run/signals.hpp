// SPDX-License-Identifier: Apache-2.0
// Stop requests: signals, a file named "stop" in the output folder, a limit of wall-clock time.
#pragma once
#include <chrono>
#include <string>

namespace thaw {

/// Makes SIGTERM, SIGINT, SIGUSR1 and SIGUSR2 only set a flag. mpirun forwards SIGUSR1 and SIGUSR2 without a
/// time limit. After SIGTERM and SIGINT it kills the job within two seconds.
void catchSignals();

/// Returns the number of the first signal caught, 0 if none.
int caughtSignal();

/// Returns a reason to stop on this rank, or "". It checks for the stop file at most twice a second.
struct StopMonitor {
  std::string stopFile;    ///< path
  double timeLimit = 0;    ///< s of wall-clock time, 0: none
  bool requested = false;  ///< by the program
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now(), looked{};
  std::string reason();
};

}  // namespace thaw
