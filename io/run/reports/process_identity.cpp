// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/process_identity.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

using Json = nlohmann::ordered_json;

namespace thaw {
namespace {

struct Stat {
  char state = '?';
  long long began = 0;
};

/// Reads fields 3 and 22 of /proc/PID/stat. Field 2 is a name in brackets with any content.
Stat statOf(long pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name = all.rfind(')');
  Stat s;
  if (name == all.npos) return s;
  std::istringstream fields(all.substr(name + 1));
  std::string skipped;
  fields >> s.state;
  for (int k = 4; k < 22; k++) fields >> skipped;
  if (!(fields >> s.began)) s.began = 0;
  return s;
}

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

}  // namespace

ProcessIdentity ownProcess() { return {hostName(), getpid(), statOf(getpid()).began}; }

ProcessState processStateOf(const ProcessIdentity& p) {
  if (p.pid <= 0 || p.host.empty() || p.host != hostName()) return ProcessState::Unknown;
  if (kill(static_cast<pid_t>(p.pid), 0) != 0 && errno == ESRCH) return ProcessState::Gone;
  const Stat s = statOf(p.pid);
  const bool ended = s.state == 'Z' || s.state == 'X',
             another = p.began > 0 && s.began > 0 && s.began != p.began;
  return ended || another ? ProcessState::Gone : ProcessState::Here;
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Json processJson() {
  const ProcessIdentity p = ownProcess();
  return {{"host", p.host}, {"pid", p.pid}, {"began_ticks", p.began}, {"written", utcNow()}};
}

std::string runningText(const Json& summary) {
  if (!summary.contains("process")) return "running, or killed,";  // no entry: older file format
  const Json& j = summary["process"];
  const ProcessIdentity p{j.at("host").get<std::string>(), j.at("pid").get<long>(),
                          j.at("began_ticks").get<long long>()};
  const std::string who = fmt::format("process {} on {}", p.pid, p.host),
                    written = "last write at " + j.at("written").get<std::string>();
  switch (processStateOf(p)) {
    case ProcessState::Here: return fmt::format("running ({}; {}),", who, written);
    case ProcessState::Gone: return fmt::format("killed ({} has ended; {}), last known", who, written);
    case ProcessState::Unknown: break;
  }
  return fmt::format("running, or killed, on another host ({}; {}),", who, written);
}

}  // namespace thaw
