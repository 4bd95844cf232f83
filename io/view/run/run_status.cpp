// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/run_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/run/reports/progress.hpp"
#include "io/run/reports/summary.hpp"
#include "io/run/reports/warning_file.hpp"
#include "io/run/run_lock.hpp"
#include "io/view/run/run_files.hpp"
#include "io/view/run/stop_request.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

Json summaryOf(const fs::path& run) {
  const auto path = fileInRun(run, summaryName);
  if (!path) return Json::object();
  std::ifstream file(*path);
  const Json all = Json::parse(file, nullptr, false);
  Json shown = Json::object();
  if (!all.is_object()) return shown;
  for (const auto& [key, value] : all.items())
    if (key != "phases_s_per_rank" && key != "traffic" && key != "ledger" && key != "counters")
      shown[key] = value;
  if (const auto phases = all.find("phases_s_per_rank"); phases != all.end() && phases->is_object())
    for (const auto& [name, times] : phases->items())
      if (times.is_object() && times.contains("mean")) shown["phases_s"][name] = times["mean"];
  return shown;
}

std::string textIn(const Json& object, const char* key) {
  return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : std::string();
}

/// Replaces the warnings of the summary by those in warnings.json, unless the summary is newer.
void addNewWarnings(const fs::path& run, Json& summary) {
  const auto path = fileInRun(run, warningsName), old = fileInRun(run, summaryName);
  if (!path) return;
  std::error_code error;
  if (old && fs::last_write_time(*path, error) < fs::last_write_time(*old, error)) return;
  std::ifstream file(*path);
  const Json list = Json::parse(file, nullptr, false);
  if (list.is_array() && std::all_of(list.begin(), list.end(), [](const Json& w) { return w.is_string(); }))
    summary["warnings"] = list;
}

/// Sets state, text and live.
void setState(const fs::path& run, const Json& summary, Json& status) {
  const std::string written = textIn(summary, "status"), message = textIn(summary, "message");
  const auto set = [&](const char* state, const std::string& text, bool live) {
    status["state"] = state, status["text"] = text, status["live"] = live;
  };
  if (const std::optional<LockHolder> holder = lockHolder(run.string())) {
    const std::string who = holderText(*holder);
    switch (processStateOf(holder->process)) {
      case ProcessState::Here: return set("running", "running: " + who, true);
      case ProcessState::Gone: return set("killed", "killed: " + who + " has ended", false);
      case ProcessState::Unknown: return set("running", "running, as far as the files say: " + who, true);
    }
  }
  if (written == "running") return set("killed", "killed: no lock", false);
  if (written == "done" || written == "stopped" || written == "failed" || written == "refused")
    return set(written.c_str(), message.empty() ? written : written + ": " + message, false);
  set("unknown", "no summary.json", false);
}

/// Returns the last line of progress.csv; numbers where the cells are numbers.
Json progressOf(const fs::path& run) {
  Json progress = Json::object();
  if (!logInRun(run, "progress.csv")) return progress;
  for (const auto& [name, text] : lastProgress(run.string())) {
    const Json value = Json::parse(text, nullptr, false);
    progress[name] = value.is_number() ? value : Json(text);
  }
  return progress;
}

double ageOf(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (error) return -1;
  const double age = std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count();
  return std::max(0.0, age);
}

}  // namespace

Json runStatus(const fs::path& run) {
  Json status;
  Json summary = summaryOf(run);
  addNewWarnings(run, summary);
  setState(run, summary, status);
  std::error_code error;
  status["stop_requested"] = status["live"].get<bool>() && fs::exists(run / stopName, error);
  status["age_s"] = ageOf(progressLogPath(run.string()));
  status["progress"] = progressOf(run);
  status["summary"] = summary;
  return status;
}

}  // namespace thaw
