// SPDX-License-Identifier: Apache-2.0
#include "io/run/signals.hpp"

#include <csignal>
#include <cstring>
#include <filesystem>

namespace thaw {
namespace {

volatile std::sig_atomic_t signalCaught = 0;  // the only type that a signal handler may write

extern "C" void recordSignal(int number) {
  if (signalCaught == 0) signalCaught = number;
}

}  // namespace

void catchSignals() {
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = recordSignal;
  for (int s : {SIGTERM, SIGINT, SIGUSR1, SIGUSR2}) sigaction(s, &action, nullptr);
}

int caughtSignal() { return signalCaught; }

std::string StopMonitor::reason() {
  if (const int s = caughtSignal()) return std::string("signal ") + strsignal(s);
  if (requested) return "request of the program";
  const auto now = std::chrono::steady_clock::now();
  if (timeLimit > 0 && std::chrono::duration<double>(now - start).count() >= timeLimit) return "time limit";
  if (!stopFile.empty() && std::chrono::duration<double>(now - looked).count() > 0.5) {
    looked = now;
    std::error_code code;
    if (std::filesystem::exists(stopFile, code)) return "stop file";
  }
  return "";
}

}  // namespace thaw
