// SPDX-License-Identifier: Apache-2.0
// Identity of the process that writes a run. It distinguishes killed runs from live ones.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace thaw {

/// A Linux process. Its start distinguishes it from a later process with the same number.
struct ProcessIdentity {
  std::string host;
  long pid = 0;
  long long began = 0;  ///< start in clock ticks since the boot of the host; 0 if unknown
};

ProcessIdentity ownProcess();

enum class ProcessState { Here, Gone, Unknown };  ///< Unknown: on another host
/// Returns whether a process exists, as far as this host can determine.
ProcessState processStateOf(const ProcessIdentity& process);

/// Returns the time, "2030-01-02T03:04:05Z".
std::string utcNow();

/// Returns this process and the time (UTC), for the summary of a live run.
nlohmann::ordered_json processJson();
/// Returns "running (process 12 on node3)", "killed (...)", or a text for another host. Requires: a summary
/// with status "running".
std::string runningText(const nlohmann::ordered_json& summary);

}  // namespace thaw
