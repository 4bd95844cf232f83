// SPDX-License-Identifier: Apache-2.0
#include "io/commands/info_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/simulation/world/body_types.hpp"
#include "io/run/reports/process_identity.hpp"
#include "io/run/run_lock.hpp"
#include "io/text/bytes_text.hpp"
#include "io/text/short_text.hpp"
#include "io/text/speed_text.hpp"

using Json = nlohmann::ordered_json;

namespace thaw {
namespace {

constexpr std::size_t mostWarnings = 6, longest = 200;  // lines of warnings; characters of a line

double numberOf(const Json& j, const char* key) {
  return j.contains(key) && j[key].is_number() ? j[key].get<double>() : 0;
}
std::string textOf(const Json& j, const char* key) {
  return j.contains(key) && j[key].is_string() ? j[key].get<std::string>() : std::string();
}
std::string named(const char* what, const std::string& text) {
  return fmt::format("  {:<12} {}", what, text);
}

/// Returns the names of extensions in the summary, or in the newest checkpoint.
std::string extensionsText(const Json& run, const Json& summary) {
  const auto names = summary.value("extensions", std::vector<std::string>{});
  const std::string text = fmt::format("{}", fmt::join(names, ", "));
  return text.empty() && !run["checkpoints"].empty() ? textOf(run["checkpoints"][0], "extensions") : text;
}

/// Returns the counters that are not 0: "melted 12, frozen 3".
std::string countsText(const Json& counters) {
  std::string text;
  for (const auto& [name, count] : counters.items())
    if (count.is_number() && count.get<double>() != 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count.get<std::int64_t>());
  return text;
}

void addCheckpoints(const Json& run, std::vector<std::string>& lines) {
  std::string text;
  for (const Json& c : run["checkpoints"])
    text += fmt::format("{}step {} at t {:.6g} s ({})", text.empty() ? "" : ", ",
                        c["step"].get<std::int64_t>(), c["time"].get<double>(),
                        bytesText(numberOf(c, "bytes")));
  lines.push_back(named("checkpoints", !text.empty()              ? text
                                       : run.contains("problems") ? "none readable"
                                                                  : "none"));
}

void addFrames(const Json& run, std::vector<std::string>& lines) {
  for (const Json& s : run["series"])
    lines.push_back(
        named("frames", fmt::format("{}, t {:.6g} to {:.6g} s: {}", s["frames"].get<std::size_t>(),
                                    numberOf(s, "first_time"), numberOf(s, "last_time"), textOf(s, "path"))));
}

void addContents(const Json& s, std::vector<std::string>& lines) {
  std::string text;
  if (s.contains("particles"))
    text = fmt::format("{} particles, {:.1f} % liquid", s["particles"].get<std::int64_t>(),
                       100 * numberOf(s, "liquid_fraction"));
  for (const char* kind : bodyTypeNames)
    if (s.contains(kind))
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", kind, s[kind].get<std::int64_t>());
  if (s.contains("surface"))
    text += fmt::format(", {} surfels in {} component{}", s["surface"].at("surfels").get<std::int64_t>(),
                        s["surface"].at("components").size(),
                        s["surface"].at("components").size() == 1 ? "" : "s");
  lines.push_back(named("content", text));
  lines.push_back(named(
      "time step", fmt::format("{:.3g} s, limited by {}", numberOf(s, "dt_s"), textOf(s, "dt_limited_by"))));
}

void addLedger(const Json& s, std::vector<std::string>& lines) {
  if (!s.contains("ledger")) return;
  const Json &l = s["ledger"], &now = l.at("now"), &residual = l.at("residual");
  lines.push_back(named(
      "energy",
      fmt::format(
          "kinetic {:.4g} J, elastic {:.4g} J, potential {:.4g} J, dissipated {:.4g} J, heat in {:.4g} J",
          numberOf(now, "kinetic_J"), numberOf(now, "elastic_J"), numberOf(now, "potential_J"),
          numberOf(l, "dissipated_J"), numberOf(l, "heat_in_J"))));
  lines.push_back(named(
      "residuals", fmt::format("mass {:+.1e} of {:.6g} kg, mechanical energy {:+.2e} J, heat {:+.1e} J",
                               numberOf(residual, "mass_kg"), numberOf(now, "mass_kg"),
                               numberOf(residual, "mechanical_energy_J"), numberOf(residual, "heat_J"))));
}

}  // namespace

std::vector<std::string> summaryOfRun(const Json& run) {
  std::vector<std::string> lines;
  const Json none = Json::object(), &s = run.contains("summary") ? run["summary"] : none;
  const std::string title = textOf(s, "title"), message = textOf(s, "message");
  lines.push_back(fmt::format("{}: a run of {}{}", textOf(run, "path"),
                              s.contains("scene") ? textOf(s, "scene") : "an unknown scene (no summary.json)",
                              title.empty() ? "" : ": " + shortText(title, longestTitle)));
  if (s.contains("status"))
    lines.push_back(named(
        "status", fmt::format("{} at t {:.6g} of {:.6g} s, step {}{}",
                              textOf(s, "status") == "running" ? runningText(s) : textOf(s, "status"),
                              numberOf(s, "time_s"), numberOf(s, "end_s"), s.value("step", std::int64_t(0)),
                              message.empty() ? "" : ": " + message)));
  // summary.json is as old as the last checkpoint or frame.
  if (textOf(s, "status") == "running" && run.contains("progress") &&
      numberOf(run["progress"], "step") > numberOf(s, "step")) {
    const Json& p = run["progress"];
    lines.push_back(
        named("progress",
              fmt::format("t {:.6g} s, step {}, dt {:.3g} s (limited by {}), {:.3g} steps/s",
                          numberOf(p, "time_s"), static_cast<std::int64_t>(numberOf(p, "step")),
                          numberOf(p, "dt_s"), textOf(p, "dt_limited_by"), numberOf(p, "steps_per_second"))));
  }
  if (const std::string names = extensionsText(run, s); !names.empty())
    lines.push_back(named("extensions", names));
  if (run.contains("lock")) lines.push_back(named("in use", lockText(run["lock"])));
  addCheckpoints(run, lines);
  addFrames(run, lines);
  if (s.contains("status")) {
    addContents(s, lines);
    lines.push_back(
        named("performance",
              fmt::format("{:.4g} s on {} rank{}, {}, imbalance {:.2f}, {} per rank", numberOf(s, "wall_s"),
                          s.value("ranks", 1), s.value("ranks", 1) == 1 ? "" : "s",
                          speedText(numberOf(s, "particle_steps_per_second")), numberOf(s, "imbalance"),
                          bytesText(numberOf(s, "peak_memory_bytes")))));
    addLedger(s, lines);
    if (s.contains("counters"))
      if (const std::string counts = countsText(s["counters"]); !counts.empty())
        lines.push_back(named("counters", counts));
  }
  for (const char* list : {"problems", "warnings"}) {
    const Json& from = std::string(list) == "problems" ? run : s;
    if (!from.contains(list)) continue;
    const Json& all = from[list];
    for (std::size_t k = 0; k < std::min(mostWarnings, all.size()); k++) {
      const std::string text = all[k].get<std::string>();
      lines.push_back(named(k == 0 ? list : "", shortText(text, longest)));
    }
    if (all.size() > mostWarnings)
      lines.push_back(named("", fmt::format("and {} more", all.size() - mostWarnings)));
  }
  return lines;
}

Json shortCheckpoint(Json j) {
  j.erase("ledger");
  for (const char* group : {"particles", "solids", "bonds", "surfels", "oriented", "sheet"})
    j.erase(std::string(group) + "_fields");
  if (j.contains("counters")) {
    Json counts = Json::object();
    for (const auto& [name, count] : j["counters"].items())
      if (count != 0) counts[name] = count;
    j["counters"] = counts;
    if (counts.empty()) j.erase("counters");
  }
  return j;
}

}  // namespace thaw
