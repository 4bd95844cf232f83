// SPDX-License-Identifier: Apache-2.0
#include "io/commands/info_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include "core/simulation/ledger/totals.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/checkpoint/damaged_rows.hpp"
#include "io/commands/info_summary.hpp"
#include "io/frames/body_type_frame.hpp"
#include "io/frames/series.hpp"
#include "io/run/reports/progress.hpp"
#include "io/run/run_lock.hpp"
#include "io/text/command_error.hpp"

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace thaw {
namespace {

std::uint64_t fileBytes(const std::string& path) {
  std::error_code error;
  const std::uint64_t n = fs::file_size(path, error);
  return error ? 0 : n;
}

Json fieldOf(const H5File& file, const std::string& name, const std::string& path, bool range) {
  const DatasetShape s = file.shape(path);
  const int components = std::max(s.components, 1);
  Json j = {{"name", name},
            {"type", nameOf(s.element)},
            {"components", components},
            {"unit", file.hasAttribute(path, "units") ? file.text(path, "units") : std::string("1")}};
  if (!range || s.element == Element::Other || s.rows == 0) return j;
  // The range covers all components of vectors and tensors.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::uint64_t notFinite = 0;
  std::vector<double> values;
  constexpr std::uint64_t piece = 1 << 20;
  for (std::uint64_t at = 0; at < s.rows; at += piece) {
    const std::uint64_t n = std::min(piece, s.rows - at);
    values.resize(n * static_cast<std::size_t>(components));
    file.read(path, {at, n}, Element::F64, values.data());
    for (double v : values) {
      if (!std::isfinite(v)) notFinite++;
      else low = std::min(low, v), high = std::max(high, v);
    }
  }
  if (low <= high) j["min"] = low, j["max"] = high;
  if (notFinite > 0) j["not_finite"] = notFinite;
  return j;
}

Json frameInfo(const std::string& path) {
  const FrameInfo info = readFrameInfo(path);
  const H5File file = H5File::openToRead(path);
  const std::string kind = pointTypeOf(file);
  Json j = {{"kind", kind == "particles" ? std::string("frame")
                     : kind == "surfels" ? std::string("frame of a surface")
                                         : "frame of kind " + kind},
            {"path", path},
            {"bytes", fileBytes(path)},
            {"step", info.step},
            {"time", info.time},
            {kind, info.count},
            {"pieces", info.pieces},
            {"scene", info.sceneName},
            {"code", info.code},
            {"commit", info.commit},
            {"ranks", info.ranks}};
  for (const FrameInfo::Field& f : info.fields)
    j["fields"].push_back(
        fieldOf(file, f.name, f.name == "position" ? "/VTKHDF/Points" : "/VTKHDF/PointData/" + f.name, true));
  return j;
}

Json checkpointInfo(const CheckpointHeader& header, bool fields) {
  CheckpointHeader h = header;
  Json j = {{"kind", "checkpoint"},      {"path", h.path},       {"bytes", fileBytes(h.path)},
            {"step", h.clock.step},      {"time", h.clock.time}, {"dt", h.clock.dt},
            {"limited_by", h.limitedBy}, {"end", h.clock.end},   {"next_frame", h.clock.frame},
            {"particles", h.particles},  {"solids", h.solids},   {"bonds", h.bonds},
            {"sequence", h.sequence},    {"scene", h.sceneName}, {"code", h.code},
            {"commit", h.commit},        {"ranks", h.ranks}};
  if (!h.extensions.empty()) j["extensions"] = h.extensions;
  if (h.surface.there) {
    j["surface"] = {{"surfels", h.surfels},
                    {"components", h.surface.components.size()},
                    {"events", h.surface.events.size()},
                    {"last_update_step", h.surface.lastStep}};
    for (const NamedCount& c : countsOf(h.surface.counters)) j["surface"][c.name] = *c.count;
  }
  for (std::size_t k = 0; k < bodyTypeCount; k++)
    if (h.bodyTypeRows[k]) j[bodyTypeNames[k]] = *h.bodyTypeRows[k];
  for (const NamedCount& c : countsOf(h.counters)) j["counters"][c.name] = *c.count;
  for (const NamedSum& s : sumsOf(h.ledger)) j["ledger"][s.name] = s.sum->value();
  if (!fields) return j;
  const H5File file = H5File::openToRead(h.path);
  if (const std::vector<std::string> damaged = damagedRows(file); !damaged.empty()) j["damaged"] = damaged;
  for (const char* group : {"/particles", "/solids", "/bonds", "/surfels", "/oriented", "/sheet"}) {
    if (!file.has(group) && (std::string(group) == "/surfels" || std::string(group) == "/oriented" ||
                             std::string(group) == "/sheet"))
      continue;
    j[std::string(group + 1) + "_fields"] = Json::array();
    if (file.has(group))
      for (const std::string& name : file.children(group))
        j[std::string(group + 1) + "_fields"].push_back(fieldOf(file, name, group + ("/" + name), false));
  }
  return j;
}

Json seriesInfo(const std::string& path) {
  const std::vector<SeriesEntry> entries = readSeries(path);
  Json j = {{"kind", "series"}, {"path", path}, {"frames", entries.size()}};
  if (!entries.empty())
    j["first_time"] = entries.front().time, j["last_time"] = entries.back().time,
    j["last"] = entries.back().name;
  return j;
}

Json folderInfo(const std::string& path) {
  Json j = {{"kind", "run"}, {"path", path}};
  std::vector<std::string> problems;
  const std::vector<CheckpointHeader> checkpoints = findCheckpoints(path, &problems);
  if (!checkpoints.empty()) j["step"] = checkpoints[0].clock.step, j["time"] = checkpoints[0].clock.time;
  j["checkpoints"] = Json::array();
  for (const CheckpointHeader& h : checkpoints) j["checkpoints"].push_back(checkpointInfo(h, false));
  j["series"] = Json::array();
  for (const std::string& s : findSeries(path)) {
    try {
      j["series"].push_back(seriesInfo(s));
    } catch (const IoError& e) { problems.push_back(e.what()); }
  }
  if (std::ifstream summary(path + "/summary.json"); summary) {
    Json s = Json::parse(summary, nullptr, false);
    if (s.is_discarded()) problems.push_back(path + "/summary.json: is not JSON");
    else j["summary"] = std::move(s);
  }
  if (const std::map<std::string, std::string> last = lastProgress(path); !last.empty())
    for (const char* name : {"step", "time_s", "dt_s", "dt_limited_by", "steps_per_second", "seconds_left"})
      if (const auto at = last.find(name); at != last.end()) {
        const Json value = Json::parse(at->second, nullptr, false);
        j["progress"][name] = value.is_number() ? value : Json(at->second);
      }
  if (const std::optional<LockHolder> holder = lockHolder(path)) j["lock"] = lockJson(*holder);
  if (!problems.empty()) j["problems"] = problems;
  if (checkpoints.empty() && j["series"].empty() && !j.contains("summary") && problems.empty())
    throw IoError(path, "is not a run folder: it has no checkpoint, no frames and no summary.json");
  return j;
}

/// Returns a value with six digits; --json has all digits.
std::string textOf(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (value.is_array()) {
    std::string all;
    for (const Json& item : value) all += (all.empty() ? "" : ", ") + textOf(item);
    return "[" + all + "]";
  }
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Prints "name  value" lines, nested objects indented, and a list of fields as a table.
void print(const Json& j, int indent) {
  for (const auto& [key, value] : j.items()) {
    const std::string lead(static_cast<std::size_t>(indent), ' ');
    if (value.is_object()) {
      fmt::print("{}{}\n", lead, key);
      print(value, indent + 2);
    } else if (value.is_array() && !value.empty() && value[0].is_object()) {
      fmt::print("{}{}\n", lead, key);
      for (const Json& item : value) {
        if (item.contains("components")) {
          const std::string range = item.contains("min")
                                        ? fmt::format("{:.6g} .. {:.6g}", item["min"].get<double>(),
                                                      item["max"].get<double>())
                                        : std::string();
          const std::string bad = item.contains("not_finite")
                                      ? fmt::format("  {} NOT FINITE",
                                                    item["not_finite"].get<std::uint64_t>())
                                      : std::string();
          fmt::print("{}  {:<16} {:>8} x {}  {:<10} {}{}\n", lead, item["name"].get<std::string>(),
                     item["type"].get<std::string>(), item["components"].get<int>(),
                     item["unit"].get<std::string>(), range, bad);
        } else {
          print(item, indent + 2);
          if (&item != &value.back()) fmt::print("\n");
        }
      }
    } else if (!(value.is_array() && value.empty())) {
      fmt::print("{}{:<16} {}\n", lead, key, textOf(value));
    }
  }
}

void printShort(const Json& j) {
  if (j["kind"] == "run") {
    for (const std::string& line : summaryOfRun(j)) fmt::print("{}\n", line);
  } else {
    print(j["kind"] == "checkpoint" ? shortCheckpoint(j) : j, 0);
  }
  if (j["kind"] == "run" || j["kind"] == "checkpoint") fmt::print("for all details: --all or --json\n");
}

}  // namespace

CLI::App* addInfoCommand(CLI::App& app, InfoArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "info", "describe a frame, a checkpoint, an index of frames or a run folder");
  command->add_option("PATH", arguments.path, "a file written by thaw, or a run folder")->required();
  command->add_flag("--all", arguments.all, "print all details instead of a summary");
  command->add_flag("--json", arguments.json, "print all details as JSON");
  return command;
}

Json describePath(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return folderInfo(path);
  if (path.ends_with(".series")) return seriesInfo(path);
  const H5File file = H5File::openToRead(path);
  if (isCheckpoint(file)) return checkpointInfo(readCheckpointHeader(path), true);
  if (isFrame(file)) return frameInfo(path);
  throw IoError(path, "is neither a frame nor a checkpoint");
}

int infoCommand(const InfoArguments& arguments) {
  try {
    const Json j = describePath(arguments.path);
    if (arguments.json) fmt::print("{}\n", j.dump(2, ' ', false, Json::error_handler_t::replace));
    else if (arguments.all) print(j, 0);
    else printShort(j);
    if (!j.contains("damaged")) return 0;
    const std::string damage = damageText(j["damaged"].get<std::vector<std::string>>());
    printCommandError("info", arguments.path + ": " + damage);
  } catch (const IoError& e) { printCommandError("info", e.what()); } catch (const Json::exception& e) {
    printCommandError("info", fmt::format("{}: summary.json was not written by this program: {}",
                                          arguments.path, e.what()));
  } catch (const std::bad_alloc&) { printCommandError("info", "out of memory"); }
  return exitInputOutput;
}

}  // namespace thaw
