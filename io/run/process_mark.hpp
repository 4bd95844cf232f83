// Which process writes a run, so that what has been killed can be told from what runs.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace thaw {

/// A process of Linux: a number is given anew some time after its process has gone, but not with the same
/// start.
struct ProcessMark {
  std::string host;
  long pid = 0;
  long long began = 0;  ///< clock ticks since the host was started; 0 where the system does not tell
};

ProcessMark ownProcess();

enum class Presence { Here, Gone, Unknown };  ///< Unknown: it is another host's
/// As seen from this process.
Presence presenceOf(const ProcessMark& process);

/// "2030-01-02T03:04:05Z".
std::string utcNow();

/// Of a summary that a run has written on its way: its process, and when it was written (UTC).
nlohmann::ordered_json processJson();
/// "running (process 12 on node3)", "killed (...)", or what can be said of a run on another host; of a
/// summary whose status is "running".
std::string runningText(const nlohmann::ordered_json& summary);

}  // namespace thaw
