// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/shapes/shape_volume.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/phase_density.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/memory.hpp"
#include "core/simulation/setup/warnings/empty_regions.hpp"
#include "core/simulation/setup/warnings/thick_flow.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/simulation/world/body_types.hpp"
#include "core/time/frame_times.hpp"
#include "io/commands/check/check_report.hpp"
#include "io/commands/check/check_surface.hpp"
#include "io/commands/check/frontier_file.hpp"
#include "io/commands/check/setting_trials.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/run/reports/surface_summary.hpp"
#include "io/run/require_memory.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/scene/scene_warnings.hpp"
#include "io/text/number_options.hpp"
#include "parallel/mpi_simulation.hpp"

namespace thaw {
namespace {

/// Adds the counts of oriented bodies and sheets. Collective.
void countBodyTypes(const OrientedBodies& oriented, const Scene& scene, const SheetBodies& sheets,
                    Reducer& all, CheckReport& r) {
  const auto count = [&](const BodyTypeRows& rows, const auto& bodies, auto& to) {
    std::vector<std::int64_t> of(bodies.size(), 0);
    for (std::size_t i = 0; i < rows.owned && !of.empty(); i++) of[rows.body[i]]++;
    all.sum(of);
    for (std::size_t b = 0; b < of.size(); b++) to.emplace_back(bodies[b].name, of[b]);
  };
  count(oriented.rows, scene.oriented, r.oriented);
  count(sheets.rows, scene.sheets, r.sheets);
}

constexpr std::size_t mostVolumes = 100;  // computing the volume of a shape takes time

/// Density (kg/m^3) of a body of one temperature.
double startDensity(const Scene& scene, const Modules& modules, const Body& b) {
  const Material& m = scene.materials[static_cast<std::size_t>(b.material)];
  const bool solid = modules.heat && m.melts() ? thermalOf(m, enthalpyOf(m, b.temperature)).liquid < 1
                                               : solidAtStart(scene, b);
  return solid ? solidDensityOf(m) : m.density;
}

/// Adds the continuum bodies. Collective.
void countBodies(const World& w, const SamplingReport& sampled, Reducer& all, CheckReport& r) {
  const std::vector<Body>& bodies = w.scene.bodies;
  std::vector<const Shape*> shapes;
  for (std::size_t b = 0; b < std::min(bodies.size(), mostVolumes); b++) shapes.push_back(&bodies[b].shape);
  const std::vector<double> volumes = shapeVolumes(shapes, meshLoader(), all);
  for (std::size_t b = 0; b < bodies.size(); b++) {
    const Material& m = w.scene.materials[static_cast<std::size_t>(bodies[b].material)];
    const double density = startDensity(w.scene, w.modules, bodies[b]);
    CheckedBody body{bodies[b].name, m.name, sampled.particles[b], 0, density * sampled.volume[b]};
    body.hasClamps = !bodies[b].clamp.empty();
    if (body.hasClamps) body.clamped = sampled.clamped[b];
    if (b < volumes.size() && sampled.removed == 0) body.shapeMass = density * volumes[b];
    r.bodies.push_back(std::move(body));
  }
}

/// Disables relaxation before the start, which may take hours. Returns a note for the report, or "".
std::string disableRelaxation(Scene& s) {
  std::int64_t most = 0;
  for (OrientedBody& b : s.oriented) most = std::max(most, std::exchange(b.relax, 0));
  return most == 0 ? ""
                   : fmt::format(
                         "a run relaxes the oriented bodies before the start, in {} iterations at most; this "
                         "check does not: counts, time step and run time are those before relaxation",
                         most);
}

/// Returns the number of particles that the emitters release until the end of the scene.
double emittedAtEnd(const Scene& s, const StepTools& t) {
  double n = 0;
  for (std::size_t e = 0; e < s.emitters.size(); e++)
    n += static_cast<double>(layersUntil(s.emitters[e], t.sources.emitters[e], s.end)) *
         static_cast<double>(t.sources.emitters[e].layer.size());
  return n;
}

/// Returns suggestions for the scene with the results of their trials. Collective.
std::vector<std::string> testedSuggestions(const Communicator& comm, const CheckOptions& o, const World& w,
                                           double particles, std::vector<std::string>& warnings) {
  const std::vector<Suggestion> all = frontierAdvice(frontierForAll(comm), w.scene, w.modules);
  std::vector<std::string> lines;
  if (all.empty()) return lines;
  SettingTrials trials(comm, {o.scene, o.overrides, particles});
  std::vector<std::string> failed, untried;
  for (const Suggestion& one : all) {
    const std::optional<std::string> failure = trials.failureOf(one.settings);
    if (const std::string own = trials.failureOfScene(); !own.empty()) {
      warnings.push_back("the run fails within its first steps: " + own);
      return {};
    }
    if (failure && failure->empty()) lines.push_back(one.line);
    else if (failure)
      failed.push_back(fmt::format("left out:      {} ({})", settingList(one.settings, "--set "), *failure));
    else untried.push_back(one.line + ", not tried");
  }
  if (!lines.empty())
    lines.push_back(
        fmt::format("tried on this scene for {} steps; a longer run may still fail", trials.steps()));
  lines.insert(lines.end(), failed.begin(), failed.end());
  lines.insert(lines.end(), untried.begin(), untried.end());
  if (!untried.empty())
    lines.push_back(trials.steps() > 0 ? "not tried: the time limit of the trials is reached"
                                       : "not tried: the scene is too large for a trial");
  return lines;
}

/// The simulation of a check.
struct CheckedWorld {
  const Communicator& comm;
  MpiSimulation simulation{comm};
  World& w = simulation.world;
  StepTools& t = simulation.tools;
};

/// Adds the start of the scene: geometry, emitters, modules, step limits. Requires: no step has been taken.
void describeStart(const CheckedWorld& c, const SamplingReport& sampled, CheckReport& r) {
  const World& w = c.w;
  const Scene& s = w.scene;
  r.title = s.title;
  r.spacing = s.spacing, r.support = w.grid.support, r.end = s.end, r.every = s.output.every;
  for (int axis = 0; axis < 3; axis++) r.cells[axis] = w.grid.cells[axis];
  for (std::size_t e = 0; e < s.emitters.size(); e++)
    r.emitters.push_back({s.emitters[e].name,
                          s.materials[static_cast<std::size_t>(s.emitters[e].material)].name,
                          outflowOf(c.t.sources.emitters[e]), c.t.sources.emitters[e].layer.size()});
  r.emitted = emittedAtEnd(s, c.t);
  for (const BodyOverlap& pair : sampled.overlaps) r.overlaps.push_back(pair.text);
  r.removed = static_cast<std::int64_t>(sampled.removed);
  r.modules.assign(w.modules.why.begin(), w.modules.why.end());
  if (w.clock.dt < never) r.step = w.clock.dt;
  r.longestStep = longestUnlimitedStep(w.clock);
  r.limitedBy = w.clock.limitedBy;
  r.substeps = w.clock.substeps;
  for (std::size_t k = 0; k < limitNames.size(); k++)
    if (const double limit = c.t.limits.fixed.value[k]; limit < never)
      r.limits.emplace_back(limitNames[k], limit);
  for (std::size_t k = 0; w.modules.fluid && k < s.materials.size(); k++)
    if (const Material& m = s.materials[k]; canBeLiquid(m) && inUse(s, k))
      r.sounds.push_back({m.name, c.t.liquids[k].soundSpeed, soundSpeedReason(s, m)});
  if (w.modules.flowLaw) r.flows = flowLawLines(w.scene, w.modules);
}

/// Adds the warnings of the scene and of its start.
void addWarnings(const CheckedWorld& c, const SurfaceTrial& surface, const SamplingReport& sampled,
                 CheckReport& r) {
  const Scene& s = c.w.scene;
  const auto add = [&](const std::vector<std::string>& lines) {
    r.warnings.insert(r.warnings.end(), lines.begin(), lines.end());
  };
  add(sceneWarnings(s));
  add(mergedSheetWarnings(s, surface.mergedSheets()));
  add(pieceWarnings(s, surface.pieces()));
  for (const SceneWarning& k : sampled.warnings) r.warnings.push_back(warningLine(k.where, k.text));
}

/// Adds the warnings of oriented bodies at the start.
void addIdle(const CheckedWorld& c, const std::vector<OrientedWork::Event>& idle,
             const std::vector<OrientedWork::Field>& unused, CheckReport& r) {
  const std::vector<OrientedBody>& bodies = c.w.scene.oriented;
  for (const OrientedWork::Event& e : idle)
    r.warnings.push_back(unusedEventLine(bodies[e.body], bodies[e.body].events[e.event]));
  for (const OrientedWork::Field& f : unused)
    r.warnings.push_back(unusedFieldLine(bodies[f.body], bodies[f.body].fields[f.field]));
}

/// Takes steps for up to three seconds. Returns the seconds of each. Collective.
double timeSteps(CheckedWorld& c, int& steps) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  while (steps < 20 && seconds() < 3 && c.w.clock.time < c.w.clock.end) {
    c.simulation.step();
    steps++;
  }
  return steps > 0 ? seconds() / steps : 0;
}

/// Returns the expected step (s) of the run: that of the start, or the shorter one after the solid melts.
double expectedStep(const Scene& scene, const Modules& modules, const Clock& clock,
                    const StepLimits& fixedLimits, double start) {
  double step = std::min(start, longestUnlimitedStep(clock));
  if (mayBeDry(scene, modules))
    for (const Limit l : limitsOfLiquid) step = std::min(step, fixedLimits[l]);
  return step;
}

/// Adds the estimated cost of the run, and the advice. Collective.
void estimateCost(CheckedWorld& c, const CheckOptions& o, SurfaceTrial& surface, double perStep,
                  CheckReport& r) {
  MpiReducer& all = c.simulation.all;
  World& w = c.w;
  CheckedCost& cost = r.cost;
  const LedgerReport l = reportLedger(w, c.t, all);
  const double particles = std::max<double>(1, static_cast<double>(l.particles + l.rows[0] + l.rows[1])),
               total = particles + std::max(0.0, r.emitted - static_cast<double>(w.counters.emitted));
  double memory = totalBytes(memoryOf(w, c.t));
  all.maximum({&memory, 1});
  surface.update();  // last, since it melts the world
  cost.steps = r.end / expectedStep(w.scene, w.modules, w.clock, c.t.limits.fixed, r.step.value_or(never));
  const SurfaceTrial::Forecast onSurface = surface.forecast(cost.steps, total);
  const int size = c.comm.size(), ranks = o.ranks > 0 ? o.ranks : size;
  r.surface = surface.lines(onSurface, ranks);
  r.allSettings = o.settings;
  r.advice = o.settings ? frontierLines(frontierForAll(c.comm), w.scene, w.modules)
                        : testedSuggestions(c.comm, o, w, total, r.warnings);
  // Emitted particles raise memory and run time.
  const double most = total / particles / ranks, mean = (0.5 + 0.5 * total / particles) / ranks;
  cost.stepping = cost.steps * perStep * size * mean;
  if (w.modules.rigid)
    cost.growth = growthOfCoarseRun(c.comm, {o.scene, o.overrides, total}, r.spacing, cost.steps * perStep);
  if (cost.growth) {
    cost.steps *= cost.growth->steps;
    cost.stepping = cost.steps * cost.growth->cost * perStep * size / ranks;
  }
  cost.ranks = ranks;
  cost.surface = w.modules.surface;
  cost.surfaceBytesPerRank = onSurface.bytes / ranks;
  cost.memoryPerRank = memory * size * most + cost.surfaceBytesPerRank;
  cost.bytesPerParticle = memory * size / particles;
  cost.surfaceLeast = onSurface.seconds / ranks;
  cost.surfaceMost = onSurface.secondsMost / ranks;
  cost.particleStepsPerSecond = perStep > 0 ? particles / perStep / size : 0;
}

CheckReport makeReport(const Communicator& comm, const CheckOptions& o) {
  CheckedWorld c{comm};
  World& w = c.w;
  StepTools& t = c.t;
  CheckReport r;
  r.path = o.scene;
  MpiReducer& all = c.simulation.all;
  w.scene = sceneForAll(comm, o.scene, o.overrides);
  r.relaxation = disableRelaxation(w.scene);
  const std::vector<std::string> large = requireMemoryForBodyTypes(comm, w.scene, meshLoader());
  if (o.json) r.warnings = large;
  else if (comm.rank() == 0)
    for (const std::string& line : large) std::printf("%s\n", line.c_str()), std::fflush(stdout);
  c.simulation.prepare(meshLoader());
  requireMemory(comm, w.modules, w.scene, t.sources.shapes);
  SamplingReport sampled = c.simulation.start(meshLoader());
  std::ranges::move(emptyRegions(w.scene, w.particles, meshLoader(), all),
                    std::back_inserter(sampled.warnings));
  const std::vector<OrientedWork::Event> idle = t.oriented.idle;  // at the start
  const std::vector<OrientedWork::Field> unusedFields = t.oriented.unusedFields;
  // Emission and growth in the steps below change these counts.
  countBodyTypes(w.oriented, w.scene, w.sheets, all, r);
  countBodies(w, sampled, all, r);
  SurfaceTrial surface(comm, w, meshLoader());
  describeStart(c, sampled, r);
  const double perStep = timeSteps(c, r.cost.measuredSteps);
  estimateCost(c, o, surface, perStep, r);
  addWarnings(c, surface, sampled, r);
  addIdle(c, idle, unusedFields, r);
  return r;
}

}  // namespace

void addCheckOptions(CLI::App& c, CheckOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML)")->required();
  c.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  c.add_flag("--settings", o.settings,
             "print all settings of the accuracy suite on the frontier of error against time, not only the "
             "recommended ones");
  c.add_option("--ranks", o.ranks, "number of ranks for the estimates (default: the ranks of this command)")
      ->check(aboveZero());
  c.add_flag("--json", o.json, "print the report, or the errors of the scene, as JSON");
}

std::string checkJson(const CheckOptions& options, MPI_Comm from) {
  CheckOptions o = options;
  o.json = true;
  try {
    const Communicator comm(from);
    return jsonReport(makeReport(comm, o));
  } catch (const std::runtime_error& e) {
    const auto refusal = refusalOf(e);
    return jsonErrors(o.scene, refusal ? refusal->message : o.scene + ": error: " + e.what());
  }
}

int checkCommand(const CheckOptions& o) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto failed = [&](const std::string& message, int code) {
    if (rank == 0) std::fprintf(stderr, "%s\n", message.c_str());
    if (rank == 0 && o.json) std::fputs(jsonErrors(o.scene, message).c_str(), stdout);
    return code;
  };
  try {
    const Communicator comm;
    const CheckReport report = makeReport(comm, o);
    if (rank != 0) return exitDone;
    if (o.json) std::fputs(jsonReport(report).c_str(), stdout);
    else printReport(report);
    return exitDone;
  } catch (const std::runtime_error& e) {
    if (const auto refusal = refusalOf(e)) return failed(refusal->message, refusal->code);
    return failed(o.scene + ": error: " + e.what(), exitUsage);
  } catch (const std::exception& e) {  // out of memory or a broken invariant, on this rank alone
    std::fprintf(stderr, "error: rank %d: %s\n", rank, e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}

}  // namespace thaw
