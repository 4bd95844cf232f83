// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "core/simulation/world/body_types.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/run/reports/step_log.hpp"
#include "io/text/duration_text.hpp"
#include "io/text/progress_bar.hpp"

namespace thaw {
namespace {

std::string duration(double s) {
  if (!std::isfinite(s)) return "unknown";
  if (s > 4 * 86400.0) return durationText(s);
  if (s < 100) return fmt::format("{:.0f} s", s);
  if (s < 6000) return fmt::format("{:.0f} min {:.0f} s", std::floor(s / 60), std::fmod(s, 60));
  return fmt::format("{:.0f} h {:.0f} min", std::floor(s / 3600), std::floor(std::fmod(s, 3600) / 60));
}

using Columns = std::vector<std::pair<std::string, std::string>>;

void addVector(Columns& c, const std::string& name, const char* unit, const Vec3d& v) {
  for (int a = 0; a < 3; a++)
    c.push_back({fmt::format("{}_{}_{}", name, "xyz"[a], unit), fmt::format("{}", v[a])});
}

/// Returns all columns with their values, in as many digits as make them unique.
Columns columnsOf(const Progress& p, const RunSummary& s) {
  const LedgerReport& l = s.ledger;
  Columns c;
  const auto add = [&](const char* name, auto value) { c.push_back({name, fmt::format("{}", value)}); };
  add("step", p.clock.step);
  add("time_s", p.clock.time);
  add("dt_s", p.clock.dt);
  add("dt_limited_by", p.clock.limitedBy);
  add("substeps", p.clock.substeps);
  add("steps_per_second", p.stepsPerSecond);
  add("seconds_left", p.secondsLeft);
  add("particles", l.particles);
  for (std::size_t k = 0; k < bodyTypeCount; k++) add(bodyTypeNames[k], l.rows[k]);
  add("liquid_fraction", l.liquidFraction);
  add("mass_kg", l.now.mass);
  add("mass_residual_kg", l.massResidual);
  add("mass_in_kg", l.entered.mass);
  add("mass_out_kg", l.left.mass);
  addVector(c, "momentum", "kg_m_per_s", l.now.momentum);
  addVector(c, "momentum_residual", "kg_m_per_s", l.momentumResidual);
  addVector(c, "angular_momentum", "kg_m2_per_s", l.now.angularMomentum);
  add("kinetic_J", l.now.kinetic);
  add("elastic_J", l.now.elastic);
  add("potential_J", l.now.potential);
  add("internal_J", l.now.internal);
  add("heat_in_J", l.heatIn);
  add("dissipated_J", l.dissipated);
  add("wall_work_J", l.wallWork);
  add("energy_residual_J", l.energyResidual);
  add("energy_scale_J", l.energyLargest);
  add("energy_rounding_J", l.energyRounding);
  add("heat_residual_J", l.heatResidual);
  for (const char* name : {"density", "divergence", "viscosity", "contact"}) {
    const SolverUse* use = nullptr;
    for (const SolverUse& u : s.solvers)
      if (std::string(u.name) == name) use = &u;
    c.push_back({fmt::format("{}_iterations", name), use ? fmt::format("{}", use->last) : ""});
    c.push_back({fmt::format("{}_iterations_mean", name), use ? fmt::format("{}", use->mean) : ""});
    if (std::string(name) != "contact") continue;
    add("contact_residual_m_per_s", use ? fmt::format("{}", use->residual) : "");
    add("contact_tolerance_m_per_s", use ? fmt::format("{}", use->tolerance) : "");
  }
  const SurfaceSummary& f = s.surface;
  double volume = 0;
  for (const SurfaceComponent& k : f.components) volume += k.volume;
  const auto ofSurface = [&](const char* name, auto value) {
    c.push_back({name, f.there ? fmt::format("{}", value) : ""});
  };
  ofSurface("surfels", f.surfels);
  ofSurface("components", f.components.size());
  ofSurface("surface_volume_m3", volume);
  ofSurface("seconds_per_update", f.updatesHere > 0 ? f.seconds / static_cast<double>(f.updatesHere) : 0);
  return c;
}

/// Returns the residual over the largest term of the ledger.
std::string residualShare(const LedgerReport& l) {
  return isRounding(l) ? "rounding"
                       : fmt::format("{:+.1e}", l.energyLargest > 0 ? l.energyResidual / l.energyLargest : 0);
}

std::string headOf(const Columns& columns) {
  std::string head;
  for (const auto& [name, value] : columns) head += (head.empty() ? "" : ",") + name;
  return head + "\n";
}

std::string head() { return headOf(columnsOf({}, {})); }

}  // namespace

std::string progressLine(const Progress& p, const LedgerReport& l) {
  const Clock& c = p.clock;
  std::string counts;
  for (std::size_t k = 0; k < bodyTypeCount; k++)
    if (l.rows[k] > 0) counts += fmt::format("  {} {}", bodyTypeNames[k], l.rows[k]);
  const bool continuum = l.particles > 0 || counts.empty();
  if (continuum)
    counts = fmt::format("  particles {}{}  liquid {:.1f} %", l.particles, counts, 100 * l.liquidFraction);
  // Sheets without neighbour forces have no limit; a step ends at the next frame.
  const std::string step = c.dt < never
                               ? fmt::format("{:.1e} s ({}{})", c.dt, c.limitedBy,
                                             c.substeps > 1 ? fmt::format(", {} substeps", c.substeps) : "")
                               : "without limit";
  return fmt::format("t {:.5f} s  step {}  dt {}  {:.1f} steps/s  left {}{}  residual {:+.1e} J ({})", c.time,
                     c.step, step, p.stepsPerSecond, duration(p.secondsLeft), counts, l.energyResidual,
                     residualShare(l));
}

namespace {

/// Returns the limit of a step in at most 15 characters.
std::string shortLimit(const std::string& limit) {
  constexpr std::string_view owner = "the scene's ";
  std::string text = limit.starts_with(owner) ? limit.substr(owner.size()) : limit;
  return text.size() <= 15 ? text : text.substr(0, text.find(' '));
}

/// Returns a duration in at most 9 characters.
std::string shortDuration(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  const std::string text = durationText(seconds);
  return text.size() <= 9 ? text : ">1 year";
}

/// Returns the text after the bar. detail: 0 (shortest form) to 3 (all parts).
std::string statusText(const Progress& p, const LedgerReport& l, double share, int detail) {
  const Clock& c = p.clock;
  const bool isLong = detail > 0;
  const char *gap = isLong ? "  " : " ", *unit = isLong ? " s" : "";
  const int digits = isLong ? 1 : 0;
  std::string text;
  if (detail > 1) text += fmt::format(" {:3.0f} %", 100 * share);
  text += fmt::format("{}left {}", gap, shortDuration(p.secondsLeft));
  if (detail > 2) text += fmt::format("  t {:.4g} s", c.time);
  if (c.dt < never)
    text += fmt::format("{}dt {:.{}e}{} ({})", gap, c.dt, digits, unit, shortLimit(c.limitedBy));
  if (l.particles > 0) text += fmt::format("{}liquid {:.{}f} %", gap, 100 * l.liquidFraction, digits);
  const double residual = l.energyLargest > 0 ? l.energyResidual / l.energyLargest : 0;
  if (isRounding(l)) return text + gap + (isLong ? "residual rounding" : "residual ~0");
  return text + fmt::format("{}residual {:+.{}e}", gap, residual, digits);
}

}  // namespace

std::string statusLine(const Progress& p, const LedgerReport& l) {
  constexpr int columns = 79, bar = 8;
  const double share = p.clock.end > 0 ? std::min(1.0, p.clock.time / p.clock.end) : 1;
  std::string text;
  for (int detail = 3; detail >= 0; detail--) {
    text = statusText(p, l, share, detail);
    if (static_cast<int>(text.size()) + bar <= columns) break;
  }
  return progressBar(share, bar) + text;
}

std::string progressOf(const std::vector<SolverUse>& solvers) {
  std::string line;
  for (const SolverUse& s : solvers) {
    line += fmt::format("  {} {} it", s.name, s.last);
    if (s.tolerance > 0) line += fmt::format(" ({:.0e} of {:.0e} m/s)", s.residual, s.tolerance);
  }
  return line;
}

std::string progressOf(const SurfaceSummary& s) {
  return s.there ? fmt::format("  surfels {}", s.surfels) : "";
}

std::string progressLogPath(const std::string& out) { return out + "/progress.csv"; }

void beginProgressLog(const std::string& out) { replaceTextFile(progressLogPath(out), head()); }

void addToProgressLog(const std::string& out, const Progress& p, const RunSummary& s) {
  std::string line;
  for (const auto& [name, value] : columnsOf(p, s)) line += (line.empty() ? "" : ",") + value;
  std::ofstream file(progressLogPath(out), std::ios::app);
  file << line << '\n';
  file.close();
  if (!file) throw IoError(progressLogPath(out), "cannot be written");
}

std::map<std::string, std::string> lastProgress(const std::string& out) {
  std::ifstream file(progressLogPath(out), std::ios::binary);
  std::string first, last, line;
  if (!std::getline(file, first)) return {};
  constexpr std::streamoff tail = 1 << 16;  // enough for many lines
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  if (size > tail) {
    file.seekg(size - tail);
    std::getline(file, line);  // the rest of a line
  } else {
    file.seekg(static_cast<std::streamoff>(first.size()) + 1);
  }
  while (std::getline(file, line))
    if (!file.eof()) last = line;
  std::map<std::string, std::string> columns;
  std::istringstream names(first), values(last);
  for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');)
    columns[name] = value;
  return columns;
}

void truncateProgressLog(const std::string& out, std::int64_t step) {
  truncateStepLog(progressLogPath(out), head(), step);
}

}  // namespace thaw
