// SPDX-License-Identifier: Apache-2.0
#include "io/run/open_run.hpp"

#include <cstdlib>
#include <filesystem>

#include "core/flow/density/connected_density.hpp"
#include "core/terms/extensions.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/run/reports/progress.hpp"
#include "io/run/reports/unused_sources.hpp"
#include "io/run/require_memory.hpp"
#include "io/run/resolution_line.hpp"
#include "io/run/retry.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/scene/scene_warnings.hpp"
#include "io/text/short_text.hpp"
#include "io/text/speed_text.hpp"

namespace thaw {
namespace {

/// Prepares the world of the scene, without particles. Returns warnings of a fresh run.
std::vector<std::string> prepareRun(Run& r, const MeshLoader& load) {
  if (r.options.relax > 0) {
    if (r.world.scene.oriented.empty())
      throw SceneErrors(
          {r.options.scene + ": error: there is nothing to relax: the scene has no [[oriented]]"});
    r.tools.oriented.relaxAtLeast = r.options.relax;
  }
  r.name = std::filesystem::path(r.options.scene).stem().string();
  onDisk(r, [&] {
    std::error_code code;
    std::filesystem::remove(r.options.out + "/stop", code);  // left by the previous run
  });
  std::vector<std::string> slow = requireMemoryForBodyTypes(r.comm, r.world.scene, load);
  r.prepare(load);
  for (const Extension* e : usedExtensions(r.world.scene)) r.summary.extensions.push_back(e->name);
  requireMemory(r.comm, r.world.modules, r.world.scene, r.tools.sources.shapes);
  if (r.world.modules.surface) renewSurfaceHalos(r);
  return slow;
}

/// Prints the contents of the scene and its warnings.
void describe(Run& r) {
  const char* launched = std::getenv("OMPI_COMM_WORLD_SIZE");
  int world = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &world);
  if (launched && std::atoi(launched) != world)
    r.warn(fmt::format(
        "the launcher started {} processes but MPI reports {}; use the mpirun of the MPI that thaw was built "
        "with",
        launched, world));
  const std::string title = shortText(r.world.scene.title, longestTitle);
  r.say(r.options.scene + (title.empty() ? "" : ": " + title));
  r.say("  " + resolutionLine(r.world.scene, r.options.overrides));
  for (const std::string& why : r.world.modules.why) r.say("  " + why);
  for (const std::string& line : sceneWarnings(r.world.scene)) r.warn(line);
}

const char* adviceForThinLiquid(const Scene& scene, const Modules& modules) {
  const Numerics& n = scene.numerics;
  if (modules.solid) return "choose a smaller spacing";
  if (modules.incompressible)
    return "leave out `numerics.pressure_solver`: this solver has no tension in liquid";
  if (modules.tension && !modules.continuity) return "set `numerics.tension = \"curvature\"`";
  if (!modules.continuity || n.tensileLimit < 1 || n.shifting == 0)
    return "set `numerics.density = \"continuity\"`, `numerics.tensile_limit = 1` and `numerics.shifting = "
           "0.2`";
  return "choose a smaller spacing";
}

/// Warns if connected liquid has less than 0.9 of its rest density. A carried density pulls it together
/// again, unless the resolution is too coarse; a summed density does not.
void warnOfThinLiquid(Run& r) {
  constexpr double least = 0.9;
  const double density = connectedDensity(r.world.modules, r.world.particles, r.world.neighbours,
                                          r.world.counters, r.all);
  if (density >= least) return;
  r.warn(
      fmt::format("connected liquid has {:.2f} of its rest density on average: it is torn, or a layer of "
                  "few particles. If it should stay connected, {}",
                  density, adviceForThinLiquid(r.world.scene, r.world.modules)));
}

/// Returns the end of a run that only relaxes. Sets `code` if it was stopped.
std::string relaxationEnd(const OrientedWork& o, int& code) {
  if (o.relaxStopped) code = exitStopped;
  return fmt::format("relaxation {} after {} iterations; `thaw run --restart` continues from here",
                     o.atRest         ? "reached rest"
                     : o.relaxStopped ? "was stopped"
                     : o.relaxStalled ? "made no further progress"
                                      : "did not reach rest",
                     o.relaxed);
}

/// Prints the last lines of a run.
void reportEnd(Run& r, const std::string& why) {
  const std::size_t earlierWarnings = r.summary.warnings.size();
  r.say(fmt::format("{} at t {:.6g} s, step {}{}; {} with {} rank{}, {:.1f} s", r.summary.status,
                    r.world.clock.time, r.world.clock.step, why.empty() ? "" : " (" + why + ")",
                    speedText(r.summary.particleSteps / r.summary.wall), r.comm.size(),
                    r.comm.size() == 1 ? "" : "s", r.summary.wall));
  for (const std::string& line : surfaceLines(r.summary.surface)) r.say(line);
  for (const std::string& w : warningsOf(r.summary.counters, r.summary.ledger)) r.warn(w);
  for (const std::string& w : surfaceWarnings(r.summary.surface)) r.warn(w);
  if (earlierWarnings > 0 && r.writes())
    r.say(fmt::format("{} warning{} above {} also in {}/summary.json", earlierWarnings,
                      earlierWarnings == 1 ? "" : "s", earlierWarnings == 1 ? "is" : "are", r.options.out));
}

}  // namespace

Opened openRun(Run& r, Scene scene) {
  const MeshLoader load = meshLoader();
  r.world.scene = std::move(scene);
  const std::vector<std::string> slow = prepareRun(r, load);
  describe(r);
  if (!r.options.restart && !r.options.resume)
    for (const std::string& line : slow) r.say(line);
  begin(r, load);
  if (r.stoppedInRelaxation) {
    const std::string why = fmt::format(
        "stopped during relaxation before the start, after {} iterations: nothing is written, and the next "
        "run starts from the beginning",
        r.tools.oriented.relaxed);
    summariseStoppedRelaxation(r, why);
    r.say(why);
    return Opened::StoppedInRelaxation;
  }
  beginRetries(r);
  const Clock& c = r.world.clock;
  if (r.resumed && (c.time >= c.end || (r.options.steps >= 0 && c.step >= r.options.steps))) {
    r.say(fmt::format("nothing left to do: {} is reached; the folder is unchanged",
                      c.time >= c.end ? "the end of the scene" : "the number of steps"));
    return Opened::NothingLeft;
  }
  // Write the line of this step again, with the changes of the restart.
  if (r.resumed) onDisk(r, [&] { truncateProgressLog(r.options.out, c.step - 1); });
  report(r);
  summarise(r, "running", "");
  r.stepping = true;
  if (r.options.profile) {
    r.profile = std::make_unique<Profile>(static_cast<std::size_t>(r.options.traceSteps));
    beginProfile(*r.profile, r.tools.times, r.comm);
  }
  return Opened::Ready;
}

int finishRun(Run& r, int code, std::string why) {
  const Clock& c = r.world.clock;
  reportProfile(r);
  if (r.options.relax > 0) why = relaxationEnd(r.tools.oriented, code);  // without steps
  else if (code == exitDone && c.time < c.end) why = "--steps is reached; --restart continues";
  if (code == exitDone || code == exitStopped) {
    if (c.step != r.stepAtReport) report(r);
    writeLastSnapshot(r);
    writeCheckpointOf(r);
    warnOfThinLiquid(r);
    for (const std::string& line : unusedSourceWarnings(r.world.ledger, r.world.scene, r.all)) r.warn(line);
  }
  summarise(r, code == exitDone ? "done" : code == exitStopped ? "stopped" : "failed", why);
  // The caller prints the message of a failure.
  reportEnd(r, code == exitDone || code == exitStopped ? why : "");
  return code;
}

}  // namespace thaw
