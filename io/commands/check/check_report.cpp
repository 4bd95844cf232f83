// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <nlohmann/json.hpp>

#include "io/text/bytes_text.hpp"
#include "io/text/duration_text.hpp"
#include "io/text/short_text.hpp"
#include "io/text/speed_text.hpp"

namespace thaw {
namespace {

constexpr std::size_t mostBodyLines = 100;
constexpr double longestSensibleRun = 30 * 86400.0;  // s

using Lines = std::vector<std::string>;

void printLines(const Lines& lines, const char* before) {
  for (const std::string& line : lines) fmt::print("{}{}\n", before, line);
}

/// Adds the error of the mass against the shape if it is above 1 %.
std::string bodyLine(const CheckedBody& b) {
  std::string line = fmt::format("body '{}': {} particles of {}, {:.4g} kg", b.name, b.particles, b.material,
                                 b.mass);
  if (b.hasClamps) line += fmt::format(", {} of them clamped", b.clamped);
  const double ratio = b.shapeMass && *b.shapeMass > 0 ? b.mass / *b.shapeMass : 1;
  if (std::abs(ratio - 1) > 0.01)
    line += fmt::format(
        "; its shape has {:.4g} kg: the particles are {:.1f} % too {} (use a finer spacing, or multiply the "
        "density by {:.4g})",
        *b.shapeMass, 100 * std::abs(ratio - 1), ratio > 1 ? "heavy" : "light", 1 / ratio);
  return line;
}

/// Returns a line for each of the first mostBodyLines bodies, and one for all others.
Lines bodyLines(const std::vector<CheckedBody>& bodies) {
  const std::size_t shown = std::min(bodies.size(), mostBodyLines);
  Lines lines;
  for (std::size_t b = 0; b < shown; b++) lines.push_back(bodyLine(bodies[b]));
  std::int64_t particles = 0;
  double mass = 0;
  for (std::size_t b = shown; b < bodies.size(); b++)
    particles += bodies[b].particles, mass += bodies[b].mass;
  if (shown < bodies.size())
    lines.push_back(
        fmt::format("{} more bodies: {} particles, {:.4g} kg", bodies.size() - shown, particles, mass));
  return lines;
}

void printParticles(const CheckReport& r) {
  fmt::print("\nparticles\n");
  printLines(bodyLines(r.bodies), "  ");
  for (const auto& [name, rows] : r.oriented) fmt::print("  oriented body '{}': {} particles\n", name, rows);
  for (const auto& [name, rows] : r.sheets) fmt::print("  sheet '{}': {} vertices\n", name, rows);
  if (!r.relaxation.empty()) fmt::print("  {}\n", r.relaxation);
  for (const CheckedEmitter& e : r.emitters)
    fmt::print("  emitter '{}': {}, {:.4g} kg/s, layers of {} particles\n", e.name, e.material, e.rate,
               e.perLayer);
  if (r.emitted > 0) fmt::print("  emitted until the end: {}\n", countText(r.emitted));
  printLines(r.overlaps, "  ");
  if (!r.overlaps.empty()) fmt::print("  {} particles left out of overlaps\n", r.removed);
}

void printStep(const CheckReport& r) {
  if (r.step)
    fmt::print("\ntime step {:.3g} s at the start, limited by {}{}\n", *r.step, r.limitedBy,
               r.substeps > 1 ? fmt::format(", with {} substeps of solids", r.substeps) : "");
  else
    fmt::print("\ntime step: no limit at the start; each step ends at the next frame, {:g} s\n",
               r.longestStep);
  // Sheets and oriented bodies have no fixed limit.
  if (!r.limits.empty()) fmt::print("limits by the materials alone\n");
  for (const auto& [name, limit] : r.limits) fmt::print("  {:<16} {:.3g} s\n", name, limit);
  for (const CheckedSound& s : r.sounds)
    fmt::print("sound speed of liquid '{}': {:.4g} m/s, {}\n", s.material, s.speed, s.reason);
  printLines(r.flows, "");
}

void printAdvice(const CheckReport& r) {
  if (!r.advice.empty())
    fmt::print("{}", r.allSettings
                         ? "\nsettings on the frontier of error against time in similar cases, not tried on "
                           "this scene (docs/validation/accuracy.md)\n"
                         : "\nrecommended settings from similar cases, one at a time (all: --settings; "
                           "docs/validation/accuracy.md)\n");
  printLines(r.advice, "  ");
  if (!r.surface.empty()) fmt::print("\nsurface\n");
  printLines(r.surface, "  ");
}

bool splashes(const CheckedCost& c) { return c.surfaceMost > 1.2 * c.surfaceLeast; }

bool takesTooLong(const CheckedCost& c) { return c.stepping > longestSensibleRun; }

std::string tooLongText(const CheckReport& r) {
  return fmt::format(
      "the run takes more than a month: check the end ({:g} s), the spacing ({:g} m) and the "
      "stiffness of the materials (`sound_speed`, `young`)",
      r.end, r.spacing);
}

void printCost(const CheckReport& r) {
  const CheckedCost& c = r.cost;
  const char* plural = c.ranks == 1 ? "" : "s";
  const auto rangeText = [&](double before) {
    return durationText(before + c.surfaceLeast) +
           (splashes(c) ? " to " + durationText(before + c.surfaceMost) : "");
  };
  fmt::print("\nmemory per rank: {} with {} rank{} ({:.0f} bytes per particle{})\n",
             bytesText(c.memoryPerRank), c.ranks, plural, c.bytesPerParticle,
             c.surface ? ", and " + bytesText(c.surfaceBytesPerRank) + " for the surface" : "");
  fmt::print(
      "run time: about {} with {} rank{} ({} steps at {} and rank, measured here over "
      "{} steps{})\n",
      rangeText(c.stepping), c.ranks, plural, countText(c.steps), speedText(c.particleStepsPerSecond),
      c.measuredSteps,
      c.surface ? ": " + durationText(c.stepping) + ", and " + rangeText(0) + " for the surface" : "");
  if (c.growth)
    fmt::print(
        "contacts and changes of rigid pieces are included: a run with a spacing of {:.2g} m has "
        "{:.2f} times the steps expected at its start, each at {:.2f} times the cost\n",
        c.growth->spacing, c.growth->steps, c.growth->cost);
  if (takesTooLong(c)) fmt::print("warning: {}\n", tooLongText(r));
  fmt::print(
      "step and number of particles change during the run: the estimate is good to a factor of two{}\n",
      splashes(c) ? "; the higher figure is for a surface that splashes" : "");
}

using Json = nlohmann::ordered_json;

Json jsonParticles(const CheckReport& r) {
  Json to{{"bodies", Json::array()}};
  for (const CheckedBody& b : r.bodies) {
    Json body{{"name", b.name}, {"material", b.material}, {"particles", b.particles}, {"mass", b.mass}};
    if (b.shapeMass) body["shape_mass"] = *b.shapeMass;
    if (b.hasClamps) body["clamped"] = b.clamped;
    to["bodies"].push_back(std::move(body));
  }
  for (const auto& [name, rows] : r.oriented) to["oriented"].push_back({{"name", name}, {"particles", rows}});
  for (const auto& [name, rows] : r.sheets) to["sheets"].push_back({{"name", name}, {"vertices", rows}});
  if (!r.relaxation.empty()) to["relaxation"] = r.relaxation;
  for (const CheckedEmitter& e : r.emitters)
    to["emitters"].push_back(
        {{"name", e.name}, {"material", e.material}, {"rate", e.rate}, {"particles_per_layer", e.perLayer}});
  if (r.emitted > 0) to["emitted_until_end"] = r.emitted;
  if (!r.overlaps.empty()) to["overlaps"] = r.overlaps, to["left_out_of_overlaps"] = r.removed;
  return to;
}

Json jsonStep(const CheckReport& r) {
  Json to{{"start", r.step ? Json(*r.step) : Json()}, {"longest", r.longestStep}};
  if (r.step) to["limited_by"] = r.limitedBy;
  to["substeps"] = r.substeps;
  to["material_limits"] = Json::object();
  for (const auto& [name, limit] : r.limits) to["material_limits"][name] = limit;
  to["sound_speeds"] = Json::array();
  for (const CheckedSound& s : r.sounds)
    to["sound_speeds"].push_back({{"material", s.material}, {"speed", s.speed}, {"reason", s.reason}});
  if (!r.flows.empty()) to["flow_laws"] = r.flows;
  return to;
}

Json jsonCost(const CheckedCost& c) {
  Json to{{"ranks", c.ranks},
          {"memory_per_rank", c.memoryPerRank},
          {"bytes_per_particle", c.bytesPerParticle},
          {"steps", c.steps},
          {"run_time", {c.stepping + c.surfaceLeast, c.stepping + c.surfaceMost}},
          {"particle_steps_per_second", c.particleStepsPerSecond},
          {"measured_steps", c.measuredSteps}};
  if (c.growth)
    to["growth"] = {{"spacing", c.growth->spacing}, {"steps", c.growth->steps}, {"cost", c.growth->cost}};
  if (c.surface) {
    to["surface_memory_per_rank"] = c.surfaceBytesPerRank;
    to["surface_run_time"] = {c.surfaceLeast, c.surfaceMost};
  }
  return to;
}

/// Returns the location and text of an error line. Lines of overrides have no line and column.
Json errorOf(const std::string& path, const std::string& line) {
  const std::string sign = ": error: ";
  const std::size_t at = line.find(sign);
  if (at == std::string::npos) return {{"file", path}, {"message", line}};
  std::string file = line.substr(0, at);
  Json to{{"file", file}, {"message", line.substr(at + sign.size())}};
  int numbers[2] = {0, 0}, used = 0;
  const std::size_t column = file.rfind(':'),
                    row = column == std::string::npos ? column : file.rfind(':', column - 1);
  if (row == std::string::npos || row == 0 || file.rfind("--set", 0) == 0) return to;
  if (std::sscanf(file.c_str() + row, ":%d:%d%n", &numbers[0], &numbers[1], &used) != 2 ||
      row + static_cast<std::size_t>(used) != file.size())
    return to;
  to["file"] = file.substr(0, row);
  to["line"] = numbers[0];
  to["column"] = numbers[1];
  return to;
}

constexpr auto replaceInvalid = Json::error_handler_t::replace;  // paths may not be valid UTF-8

}  // namespace

void printReport(const CheckReport& r) {
  const std::string title = shortText(r.title, longestTitle);
  fmt::print("{}{}\n", r.path, title.empty() ? "" : ": " + title);
  fmt::print(
      "spacing {:g} m, support radius {:g} m, grid {} x {} x {} cells, end {:g} s, a frame every {:g} s\n",
      r.spacing, r.support, r.cells[0], r.cells[1], r.cells[2], r.end, r.every);
  printLines(r.warnings, "warning: ");
  printParticles(r);
  fmt::print("\nmodules\n");
  printLines(r.modules, "  ");
  printStep(r);
  printAdvice(r);
  printCost(r);
}

std::string jsonReport(const CheckReport& r) {
  Lines warnings = r.warnings;
  if (takesTooLong(r.cost)) warnings.push_back(tooLongText(r));
  const Json to{{"scene", r.path},
                {"title", r.title},
                {"spacing", r.spacing},
                {"support_radius", r.support},
                {"cells", {r.cells[0], r.cells[1], r.cells[2]}},
                {"end", r.end},
                {"frame_every", r.every},
                {"errors", Json::array()},
                {"warnings", warnings},
                {"particles", jsonParticles(r)},
                {"modules", r.modules},
                {"time_step", jsonStep(r)},
                {"settings", r.advice},
                {"surface", r.surface},
                {"estimate", jsonCost(r.cost)}};
  return to.dump(2, ' ', false, replaceInvalid) + "\n";
}

std::string jsonErrors(const std::string& path, const std::string& lines) {
  Json to{{"scene", path}, {"errors", Json::array()}};
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) to["errors"].push_back(errorOf(path, line));
  return to.dump(2, ' ', false, replaceInvalid) + "\n";
}

}  // namespace thaw
