// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/simulation/ledger/totals.hpp"
#include "core/simulation/world/body_types.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/run/reports/process_identity.hpp"
#include "io/text/counted.hpp"
#include "io/text/version.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

Json vec(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json balance(const Balance& b) {
  return {{"mass_kg", b.mass},
          {"momentum_kg_m_per_s", vec(b.momentum)},
          {"angular_momentum_kg_m2_per_s", vec(b.angularMomentum)},
          {"kinetic_J", b.kinetic},
          {"elastic_J", b.elastic},
          {"potential_J", b.potential},
          {"internal_J", b.internal}};
}

Json sourceJson(const SourceReport& s) {
  return {{"given_J", s.given},
          {"absorbed_J", s.absorbed},
          {"reflected_J", s.reflected},
          {"missed_J", s.missed()}};
}

Json countersJson(Counters counters) {
  Json j;
  for (const NamedCount& c : countsOf(counters)) j[c.name] = *c.count;
  return j;
}

/// Returns whether a phase is work, which load balancing can even out, and not waiting.
bool isWork(StepPhase p) {
  return p == StepPhase::Oriented || p == StepPhase::Sheet || p == StepPhase::Search ||
         p == StepPhase::Density || p == StepPhase::Forces || p == StepPhase::Viscosity ||
         p == StepPhase::Pressure || p == StepPhase::Elastic || p == StepPhase::Walls ||
         p == StepPhase::Contact || p == StepPhase::Heat || p == StepPhase::Drift || p == StepPhase::Sort;
}

/// Returns ", 12 through its high z side, 3 through its low x side". The counts are too low for a run that
/// began with a version without them.
std::string sidesLeft(const Counters& c) {
  std::string text;
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++)
      if (const std::int64_t n = c.leftThrough[a][high]; n > 0)
        text += fmt::format(", {} through its {} {} side", n, high ? "high" : "low", "xyz"[a]);
  return text;
}

/// Returns the first entries of a summary: program, status, scene, modules, numbers of particles.
Json runJson(const RunSummary& s) {
  Json j;
  j["code"] = "thaw";
  j["version"] = versionNumber();
  j["commit"] = versionCommit();
  j["status"] = s.status;
  j["message"] = s.message;
  if (s.status == "running") j["process"] = processJson();
  j["scene"] = s.sceneFile;
  j["title"] = s.title;
  j["modules"] = s.modules;
  j["extensions"] = s.extensions;
  j["ranks"] = s.ranks;
  bool bodyTypes = false;
  for (const std::int64_t rows : s.ledger.rows) bodyTypes = bodyTypes || rows > 0;
  if (s.ledger.particles > 0 || !bodyTypes) j["particles"] = s.ledger.particles;
  for (std::size_t k = 0; k < bodyTypeCount; k++)
    if (s.ledger.rows[k] > 0) j[bodyTypeNames[k]] = s.ledger.rows[k];
  return j;
}

}  // namespace

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

void gatherSummary(RunSummary& s, const World& w, const PhaseTimes& times,
                   const CommunicationStatistics& statistics, Reducer& all) {
  s.communication = gatherCommunication(statistics, {}, all);
  std::vector<double> most, least;
  std::vector<std::int64_t> sum;
  double work = 0;
  for (std::size_t k = 0; k < stepPhases; k++) {
    most.push_back(times.seconds[k]);
    least.push_back(-times.seconds[k]);
    sum.push_back(std::llround(times.seconds[k] * 1e9));
    if (isWork(static_cast<StepPhase>(k))) work += times.seconds[k];
  }
  most.push_back(work);
  most.push_back(peakMemory());
  most.push_back(static_cast<double>(w.particles.owned));
  for (std::int64_t v : {std::llround(work * 1e9), static_cast<long long>(w.particles.owned)})
    sum.push_back(v);
  Counters own = w.counters;
  for (const NamedCount& c : countsOf(own)) sum.push_back(*c.count);
  all.maximum(most);
  all.maximum(least);
  all.sum(sum);
  const double n = all.size();
  for (std::size_t k = 0; k < stepPhases; k++)
    if (most[k] > 0)
      s.phases[phaseName(static_cast<StepPhase>(k))] = {-least[k], static_cast<double>(sum[k]) * 1e-9 / n,
                                                        most[k]};
  std::size_t at = stepPhases;
  const double meanWork = static_cast<double>(sum[at]) * 1e-9 / n;
  s.imbalance = meanWork > 0 ? most[at] / meanWork : 1;
  s.peakMemory = most[at + 1];
  const double meanParticles = static_cast<double>(sum[at + 1]) / n;
  s.particleSpread = meanParticles > 0 ? most[at + 2] / meanParticles : 1;
  const std::int64_t* k = sum.data() + at + 2;
  for (const NamedCount& c : countsOf(s.counters)) *c.count = *k++;
  s.clock = w.clock;
  s.ranks = all.size();
  s.modules = w.modules.why;
  s.sceneFile = w.scene.file;
  s.title = w.scene.title;
}

Counters sumOfCounters(const Counters& own, Reducer& all) {
  Counters counters = own;
  std::vector<std::int64_t> sum;
  for (const NamedCount& c : countsOf(counters)) sum.push_back(*c.count);
  all.sum(sum);
  const std::int64_t* k = sum.data();
  for (const NamedCount& c : countsOf(counters)) *c.count = *k++;
  return counters;
}

void writeSummary(const std::string& out, const RunSummary& s, const std::string& name) {
  Json j = runJson(s);
  j["time_s"] = s.clock.time;
  j["end_s"] = s.clock.end;
  j["step"] = s.clock.step;
  j["frames"] = s.clock.frame;
  j["dt_s"] = s.clock.dt;
  j["substeps"] = s.clock.substeps;
  j["dt_limited_by"] = s.clock.limitedBy;
  j["steps_of_this_process"] = s.stepsHere;
  j["wall_s"] = s.wall;
  j["particle_steps_per_second"] = s.wall > 0 ? s.particleSteps / s.wall : 0;
  j["particle_steps_per_second_and_rank"] = s.wall > 0 ? s.particleSteps / s.wall / s.ranks : 0;
  for (const auto& [name, p] : s.phases)
    j["phases_s_per_rank"][name] = {{"min", p.least}, {"mean", p.mean}, {"max", p.most}};
  j["imbalance"] = s.imbalance;
  j["particles_max_over_mean"] = s.particleSpread;
  j["messages_sent"] = s.communication.allMessages;
  j["bytes_sent"] = s.communication.allBytes;
  j["traffic"] = communicationJson(s.communication);
  j["peak_memory_bytes"] = s.peakMemory;
  const LedgerReport& l = s.ledger;
  j["ledger"] = {{"initial", balance(l.initial)},
                 {"now", balance(l.now)},
                 {"entered", balance(l.entered)},
                 {"left", balance(l.left)},
                 {"dissipated_J", l.dissipated},
                 {"wall_work_J", l.wallWork},
                 {"heat_in_J", l.heatIn},
                 {"phase_jump_J", l.phaseJump},
                 {"restart_jump_J", l.restartJump},
                 {"wall_impulse_N_s", vec(l.wallImpulse)},
                 {"gravity_impulse_N_s", vec(l.gravityImpulse)},
                 {"residual",
                  {{"mass_kg", l.massResidual},
                   {"momentum_kg_m_per_s", vec(l.momentumResidual)},
                   {"mechanical_energy_J", l.energyResidual},
                   {"heat_J", l.heatResidual},
                   {"rounding_of_energy_J", l.energyRounding}}}};
  if (l.hasSources) {
    j["ledger"]["lamps"] = sourceJson(l.lamps);
    j["ledger"]["lasers"] = sourceJson(l.lasers);
    j["ledger"]["heated_regions"] = sourceJson(l.regions);
  }
  if (l.hasVapour) j["ledger"]["vapour"] = {{"mass_kg", l.evaporated}, {"heat_J", l.vapourHeat}};
  j["liquid_fraction"] = l.liquidFraction;
  for (const SolverUse& u : s.solvers) {
    j["solvers"][u.name] = {{"iterations_of_last_step", u.last}, {"mean_iterations", u.mean}};
    if (u.tolerance > 0) j["solvers"][u.name]["largest_overlap_m"] = u.overlap;
  }
  j["counters"] = countersJson(s.counters);
  if (s.surface.there) j["surface"] = surfaceJson(s.surface);
  j["warnings"] = s.warnings;
  replaceTextFile(out + "/" + name, j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<std::string> warningsOf(const Counters& c, const LedgerReport& l) {
  std::vector<std::string> w;
  const auto add = [&](std::int64_t n, const char* what) {
    if (n > 0) w.push_back(fmt::format("{} {}", n, what));
  };
  if (c.left > 0)
    w.push_back(fmt::format("{} left the domain{} (mass, momentum and heat are in the ledger)",
                            counted(c.left, "particle"), sidesLeft(c)));
  add(c.singularNeighbourhoods,
      "solid particles have a flat, thin or isolated neighbourhood (rank of their moment matrix < 3)");
  add(c.inverted, "times a solid particle was inverted (det F <= 0)");
  add(c.softenedParticles,
      "times a solid particle of `law = \"green\"` was compressed below 0.577 of its length, where that law "
      "softens: `law = \"corotated\"` or \"neo-hookean\" stiffens");
  add(c.coincidentPairs, "times a particle was at the position of another and was moved aside");
  add(c.viscousUnfinished, "steps needed more than `numerics.viscosity_iterations` for viscosity");
  if (c.retries > 0) w.push_back(counted(c.retries, "failure") + ": steps repeated with half the step");
  add(c.unsolvedPressures,
      "times the pressure of incompressible liquid did not converge within `numerics.max_iterations`");
  if (static_cast<double>(c.crowded) > 0.01 * static_cast<double>(l.particles))
    w.push_back(
        fmt::format("{} particles have a summed density above 1.3 times their carried density, which drifts "
                    "in long pours and splashes; `numerics.density = \"summation\"` does not drift",
                    c.crowded));
  add(c.contactUnfinished, "steps in which the contact solver of rigid pieces did not reach its tolerance");
  add(c.impactsUnfinished, "impacts on rigid pieces whose elastic solve did not reach its tolerance");
  add(c.wallProjections, "times a particle was pushed out of an obstacle");
  const double largest = l.energyLargest;
  if (!isRounding(l) && std::abs(l.energyResidual) > 0.05 * largest)
    w.push_back(fmt::format(
        "the ledger does not close: {:+.3g} J of mechanical energy ({:.0f} % of its largest term "
        "in this run) are unexplained; try shorter steps (`numerics.max_step`, or `fixed_step` if set)",
        l.energyResidual, 100 * std::abs(l.energyResidual) / largest));
  const double gained = std::max(0.05 * largest, 0.01 * std::abs(l.initial.potential));
  if (!isRounding(l) && l.dissipated < -gained)
    w.push_back(fmt::format(
        "dissipation is negative ({:.3g} J): numerical errors added kinetic energy; shorter steps "
        "(`numerics.max_step`) or a larger `artificial_viscosity` of the liquid reduce them",
        l.dissipated));
  const double heatRounding = 1e-12 *
                              std::max({std::abs(l.now.internal), std::abs(l.initial.internal), l.heatScale});
  if (std::abs(l.heatResidual) > std::max(0.05 * l.heatScale, heatRounding))
    w.push_back(fmt::format(
        "the ledger of heat does not close: {:+.3g} J ({:.0f} % of its largest term) are unexplained",
        l.heatResidual, l.heatScale > 0 ? 100 * std::abs(l.heatResidual) / l.heatScale : 100));
  return w;
}

}  // namespace thaw
