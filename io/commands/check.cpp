// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/shapes/shape_volume.hpp"
#include "core/scene/material_use.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/memory.hpp"
#include "core/simulation/setup/setup.hpp"
#include "core/simulation/world/body_types.hpp"
#include "core/time/frame_times.hpp"
#include "io/commands/check/check_surface.hpp"
#include "io/commands/check/frontier.hpp"
#include "io/commands/check/setting_trials.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/run/reports/surface_summary.hpp"
#include "io/run/require_memory.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/scene/scene_warnings.hpp"
#include "io/text/above_zero.hpp"
#include "io/text/bytes_text.hpp"
#include "io/text/duration_text.hpp"
#include "io/text/short_text.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw {
namespace {

/// Returns a line for each oriented body and each sheet. Collective.
std::vector<std::string> bodyTypeLines(const World& w, Reducer& all) {
  std::vector<std::string> lines;
  const auto count = [&](const BodyTypeRows& rows, const auto& bodies, const char* line) {
    std::vector<std::int64_t> of(bodies.size(), 0);
    for (std::size_t i = 0; i < rows.owned && !of.empty(); i++) of[rows.body[i]]++;
    all.sum(of);
    for (std::size_t b = 0; b < of.size(); b++)
      lines.push_back(fmt::format(fmt::runtime(line), bodies[b].name, of[b]));
  };
  count(w.oriented.rows, w.scene.oriented, "oriented body '{}': {} particles");
  count(w.sheets.rows, w.scene.sheets, "sheet '{}': {} vertices");
  return lines;
}

constexpr std::size_t mostBodyLines = 100;

/// Returns a line with particles, material and mass of a continuum body. Adds the error of the mass against
/// the shape if it is above 1 %.
std::string bodyLine(const World& w, const SamplingReport& sampled, std::size_t b, double volume) {
  const Body& body = w.scene.bodies[b];
  const Material& m = w.scene.materials[static_cast<std::size_t>(body.material)];
  const double mass = m.density * std::pow(w.scene.spacing, 3) * static_cast<double>(sampled.particles[b]);
  const double shape = m.density * volume, ratio = shape > 0 ? mass / shape : 1;
  std::string line = fmt::format("body '{}': {} of {}, {:.4g} kg", body.name, sampled.particles[b], m.name,
                                 mass);
  if (!body.clamp.empty()) line += fmt::format(", {} of them clamped", sampled.clamped[b]);
  if (std::abs(ratio - 1) > 0.01 && sampled.removed == 0)
    line += fmt::format(
        "; its shape has {:.4g} kg: the particles are {:.1f} % too {} (use a finer spacing, or multiply the "
        "density by {:.4g})",
        shape, 100 * std::abs(ratio - 1), ratio > 1 ? "heavy" : "light", 1 / ratio);
  return line;
}

/// Returns a line for each of the first mostBodyLines continuum bodies, and one for all others. Collective.
std::vector<std::string> bodyLines(const World& w, const SamplingReport& sampled, Reducer& all) {
  const std::vector<Body>& bodies = w.scene.bodies;
  const std::size_t shown = std::min(bodies.size(), mostBodyLines);
  std::vector<const Shape*> shapes;
  for (std::size_t b = 0; b < shown; b++) shapes.push_back(&bodies[b].shape);
  const std::vector<double> volumes = shapeVolumes(shapes, meshLoader(), all);
  std::vector<std::string> lines;
  for (std::size_t b = 0; b < shown; b++) lines.push_back(bodyLine(w, sampled, b, volumes[b]));
  std::int64_t particles = 0;
  double mass = 0;
  for (std::size_t b = shown; b < bodies.size(); b++) {
    particles += sampled.particles[b];
    mass += w.scene.materials[static_cast<std::size_t>(bodies[b].material)].density *
            std::pow(w.scene.spacing, 3) * static_cast<double>(sampled.particles[b]);
  }
  if (shown < bodies.size())
    lines.push_back(
        fmt::format("{} more bodies: {} particles, {:.4g} kg", bodies.size() - shown, particles, mass));
  return lines;
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

constexpr double longestSensibleRun = 30 * 86400.0;  // s

/// Returns the number of particles that the emitters release until the end of the scene.
double emittedAtEnd(const Scene& s, const StepTools& t) {
  double n = 0;
  for (std::size_t e = 0; e < s.emitters.size(); e++)
    n += static_cast<double>(layersUntil(s.emitters[e], t.emitters[e], s.end)) *
         static_cast<double>(t.emitters[e].layer.size());
  return n;
}

/// Returns suggestions for the scene with the results of their trials. Collective.
std::vector<std::string> testedSuggestions(const Communicator& comm, const CheckOptions& o, const World& w,
                                           double particles) {
  const std::vector<Suggestion> all = frontierAdvice(w.scene, w.modules);
  std::vector<std::string> lines;
  if (all.empty()) return lines;
  SettingTrials trials(comm, {o.scene, o.overrides, particles});
  std::vector<std::string> failed, untried;
  for (const Suggestion& one : all) {
    const std::optional<std::string> failure = trials.failureOf(one.settings);
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
  if (!untried.empty()) lines.push_back("not tried: the scene is too large for a trial");
  return lines;
}

/// Returns a line with the sound speed of each liquid and its reason.
std::vector<std::string> soundLines(const World& w, const StepTools& t) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; w.modules.fluid && k < w.scene.materials.size(); k++)
    if (const Material& m = w.scene.materials[k]; canBeLiquid(m) && inUse(w.scene, k))
      lines.push_back(fmt::format("sound speed of liquid '{}': {:.4g} m/s, {}", m.name,
                                  t.liquids[k].soundSpeed, soundSpeedReason(w.scene, m)));
  return lines;
}

int checkAll(const CheckOptions& o) {
  const Communicator comm;
  MpiReducer all(comm);
  World w;
  StepTools t;
  w.scene = sceneForAll(comm, o.scene, o.overrides);
  const std::string notRelaxed = disableRelaxation(w.scene);
  for (const std::string& line : requireMemoryForBodyTypes(comm, w.scene, meshLoader()))
    if (comm.rank() == 0) std::printf("%s\n", line.c_str()), std::fflush(stdout);
  prepareWorld(w, t, meshLoader());
  requireMemory(comm, w, t.shapes);
  MpiCellHalo cells(comm, w.grid);
  MpiBondHalo bonds(comm), edges(comm);
  std::unique_ptr<MpiCellHalo> kinds[bodyTypeCount];
  forEachBodyType(w, [&](std::size_t kind, const BodyTypeRows&, const CellTable&) {
    kinds[kind] = std::make_unique<MpiCellHalo>(comm, w.grid);
  });
  const Halos halos{all, cells, bonds, {kinds[orientedType].get(), kinds[sheetType].get()}, &edges};
  const SamplingReport sampled = startWorld(w, halos, t, meshLoader());
  const std::vector<OrientedWork::Event> idle = t.oriented.idle;  // at the start
  const std::vector<OrientedWork::Field> unusedFields = t.oriented.unusedFields;
  // Emission and growth in the steps below change these counts.
  const std::vector<std::string> ofKinds = bodyTypeLines(w, all), ofBodies = bodyLines(w, sampled, all);
  SurfaceTrial surface(comm, w, meshLoader());
  // Time a few steps.
  const auto start = std::chrono::steady_clock::now();
  int steps = 0;
  const double dt = w.clock.dt;
  const std::string limitedBy = w.clock.limitedBy,
                    substeps = w.clock.substeps > 1
                                   ? fmt::format(", with {} substeps of solids", w.clock.substeps)
                                   : "";
  while (steps < 20 && std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 3 &&
         w.clock.time < w.clock.end) {
    step(w, halos, t, {});
    steps++;
  }
  const double perStep =
      steps > 0 ? std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps : 0;
  const double needed = w.scene.end / std::min(dt, longestUnlimitedStep(w.clock));
  const LedgerReport l = reportLedger(w, t, all);
  const double particles = std::max<double>(1, static_cast<double>(l.particles + l.rows[0] + l.rows[1])),
               total = particles +
                       std::max(0.0, emittedAtEnd(w.scene, t) - static_cast<double>(w.counters.emitted));
  double memory = totalBytes(memoryOf(w, t));
  all.maximum({&memory, 1});
  surface.update();  // last, since it melts the world
  const SurfaceTrial::Forecast onSurface = surface.forecast(needed, total);
  const int ranks = o.ranks > 0 ? o.ranks : comm.size();
  const std::vector<std::string> surfaceLines = surface.lines(onSurface, ranks);
  const std::vector<std::string> advice = o.settings ? frontierLines(w.scene, w.modules)
                                                     : testedSuggestions(comm, o, w, total);
  if (comm.rank() != 0) return exitDone;

  const Scene& s = w.scene;
  std::printf("%s: %s\n", o.scene.c_str(), shortText(s.title, longestTitle).c_str());
  std::printf("spacing %g m, support radius %g m, grid %d x %d x %d cells, end %g s, a frame every %g s\n",
              s.spacing, w.grid.support, w.grid.cells.x, w.grid.cells.y, w.grid.cells.z, s.end,
              s.output.every);
  for (const std::string& line : sceneWarnings(s)) std::printf("warning: %s\n", line.c_str());
  for (const std::string& line : mergedSheetWarnings(s, surface.mergedSheets()))
    std::printf("warning: %s\n", line.c_str());
  for (const std::string& line : pieceWarnings(s, surface.pieces()))
    std::printf("warning: %s\n", line.c_str());
  for (const SceneWarning& k : sampled.warnings)
    std::printf("warning: %s\n", warningLine(k.where, k.text).c_str());
  for (const OrientedWork::Event& e : idle)
    std::printf("warning: %s\n",
                unusedEventLine(s.oriented[e.body], s.oriented[e.body].events[e.event]).c_str());
  for (const OrientedWork::Field& f : unusedFields)
    std::printf("warning: %s\n",
                unusedFieldLine(s.oriented[f.body], s.oriented[f.body].fields[f.field]).c_str());
  std::printf("\nparticles\n");
  for (const std::string& line : ofBodies) std::printf("  %s\n", line.c_str());
  for (const std::string& line : ofKinds) std::printf("  %s\n", line.c_str());
  if (!notRelaxed.empty()) std::printf("  %s\n", notRelaxed.c_str());
  const double emitted = emittedAtEnd(s, t);
  for (std::size_t e = 0; e < s.emitters.size(); e++)
    std::printf("  emitter '%s': of %s, %.4g kg/s, layers of %zu particles\n", s.emitters[e].name.c_str(),
                s.materials[static_cast<std::size_t>(s.emitters[e].material)].name.c_str(),
                outflowOf(t.emitters[e]), t.emitters[e].layer.size());
  if (emitted > 0) std::printf("  emitted until the end: %s\n", countText(emitted).c_str());
  for (const std::string& pair : sampled.overlaps) std::printf("  %s\n", pair.c_str());
  if (!sampled.overlaps.empty())
    std::printf("  %lld particles left out of overlaps\n", static_cast<long long>(sampled.removed));
  std::printf("\nmodules\n");
  for (const std::string& why : w.modules.why) std::printf("  %s\n", why.c_str());
  if (dt < never)
    std::printf("\ntime step %.3g s at the start, limited by %s%s\n", dt, limitedBy.c_str(),
                substeps.c_str());
  else
    std::printf("\ntime step: no limit at the start; each step ends at the next frame, %g s\n",
                longestUnlimitedStep(w.clock));
  const auto ofMaterials = [](double limit) { return limit < never; };
  // Sheets and oriented bodies have no fixed limit.
  if (std::any_of(t.fixedLimits.value.begin(), t.fixedLimits.value.end(), ofMaterials))
    std::printf("limits by the materials alone\n");
  for (std::size_t k = 0; k < limitNames.size(); k++)
    if (ofMaterials(t.fixedLimits.value[k]))
      std::printf("  %-16s %.3g s\n", limitNames[k], t.fixedLimits.value[k]);
  for (const std::string& line : soundLines(w, t)) std::printf("%s\n", line.c_str());
  if (!advice.empty())
    std::printf(o.settings ? "\nsettings on the frontier of error against time in similar cases, not tried "
                             "on this scene (docs/validation/accuracy.md)\n"
                           : "\nrecommended settings from similar cases, one at a time (all: --settings; "
                             "docs/validation/accuracy.md)\n");
  for (const std::string& line : advice) std::printf("  %s\n", line.c_str());
  if (!surfaceLines.empty()) std::printf("\nsurface\n");
  for (const std::string& line : surfaceLines) std::printf("  %s\n", line.c_str());
  // Emitted particles raise memory and run time.
  const double most = total / particles / ranks, mean = (0.5 + 0.5 * total / particles) / ranks;
  const double ofParticles = memory * comm.size() * most, ofSurface = onSurface.bytes / ranks,
               stepping = needed * perStep * comm.size() * mean;
  const double updating[2] = {onSurface.seconds / ranks, onSurface.secondsMost / ranks};
  const bool two = w.modules.surface, range = updating[1] > 1.2 * updating[0];
  const auto rangeText = [&](double before) {
    return durationText(before + updating[0]) + (range ? " to " + durationText(before + updating[1]) : "");
  };
  std::printf("\nmemory per rank: %s with %d rank%s (%.0f bytes per particle%s)\n",
              bytesText(ofParticles + ofSurface).c_str(), ranks, ranks == 1 ? "" : "s",
              memory * comm.size() / particles,
              two ? (", and " + bytesText(ofSurface) + " for the surface").c_str() : "");
  std::printf(
      "run time: about %s with %d rank%s (%s steps at %.3g M particle-steps/s and rank, measured here over "
      "%d steps%s)\n",
      rangeText(stepping).c_str(), ranks, ranks == 1 ? "" : "s", countText(needed).c_str(),
      perStep > 0 ? particles / perStep / comm.size() / 1e6 : 0, steps,
      two ? (": " + durationText(stepping) + ", and " + rangeText(0) + " for the surface").c_str() : "");
  if (stepping > longestSensibleRun)
    std::printf(
        "warning: the run takes more than a month: check the end (%g s), the spacing (%g m) and the "
        "stiffness of the materials (sound_speed, young)\n",
        s.end, s.spacing);
  std::printf(
      "step and number of particles change during the run: the estimate is good to a factor of two%s\n",
      range ? "; the higher figure is for a surface that splashes" : "");
  return exitDone;
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
}

int checkCommand(const CheckOptions& o) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto failed = [&](const std::string& message, int code) {
    if (rank == 0) std::fprintf(stderr, "%s\n", message.c_str());
    return code;
  };
  try {
    return checkAll(o);
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
