// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/coarse_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "core/time/frame_times.hpp"
#include "core/time/seconds_now.hpp"
#include "parallel/mpi_simulation.hpp"

namespace thaw {
namespace {

constexpr double aim = 4;                              // s, of the coarse run
constexpr double mostSecondsOfRun = 10;                // s
constexpr double leastFactor = 2, mostFactor = 4;      // 1, larger spacings resemble the scene too little
constexpr std::size_t coldSteps = 5, firstSteps = 40;  // the first steps fill caches and allocate

/// Progress of a run.
struct Mark {
  double time = 0;     ///< s, simulated
  double seconds = 0;  ///< s of processor time, which excludes other programs on the machine
  double steps = 0;
};

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Steps the simulation to its end, or until its time is used up. Returns a mark after each step; nothing if
/// a step fails. Collective, the same result on all ranks.
std::vector<Mark> runToEnd(const Communicator& comm, MpiSimulation& simulation) {
  const Clock& clock = simulation.world.clock;
  const double start = processorSeconds(), until = secondsNow() + mostSecondsOfRun;
  std::vector<Mark> marks;
  for (int over = 0; !over && clock.time < clock.end;) {
    if (simulation.step().failure != Failure::None) return {};
    double seconds = processorSeconds() - start;
    MPI_Bcast(&seconds, 1, MPI_DOUBLE, 0, comm.handle());
    over = secondsNow() > until;
    MPI_Bcast(&over, 1, MPI_INT, 0, comm.handle());
    marks.push_back({clock.time, seconds, static_cast<double>(marks.size() + 1)});
  }
  return marks;
}

/// Extrapolates from the later half of the simulated time so far to the end of the run.
Mark atEnd(const std::vector<Mark>& marks, double end) {
  const Mark last = marks.back();
  if (last.time >= end) return last;
  const Mark half = *std::find_if(marks.begin(), marks.end(),
                                  [&](const Mark& m) { return m.time >= 0.5 * last.time; });
  const double more = (end - last.time) / std::max(last.time - half.time, 1e-300);
  return {end, last.seconds + more * (last.seconds - half.seconds),
          last.steps + more * (last.steps - half.steps)};
}

}  // namespace

std::optional<RunGrowth> growthOfCoarseRun(const Communicator& comm, const TriedScene& scene, double spacing,
                                           double estimate) {
  MPI_Bcast(&estimate, 1, MPI_DOUBLE, 0, comm.handle());
  // time is inversely proportional to the fourth power of the spacing
  const double factor = std::clamp(std::pow(estimate / aim, 0.25), leastFactor, mostFactor);
  if (!(estimate / std::pow(factor, 4) < mostSecondsOfRun)) return std::nullopt;
  RunGrowth growth{factor * spacing};
  MpiSimulation simulation(comm);
  const World& w = simulation.world;
  try {
    startTrial(simulation, comm, scene, {fmt::format("spacing={}", growth.spacing)});
  } catch (const std::runtime_error&) {  // set-up fails alike on all ranks
    return std::nullopt;
  }
  const double end = w.clock.end, step = std::min(w.clock.dt, longestUnlimitedStep(w.clock));
  const std::vector<Mark> marks = runToEnd(comm, simulation);
  if (marks.size() <= firstSteps) return std::nullopt;
  const Mark whole = atEnd(marks, end), &cold = marks[coldSteps - 1], &first = marks[firstSteps - 1];
  growth.steps = whole.steps * step / end;
  growth.cost = whole.seconds / whole.steps / ((first.seconds - cold.seconds) / (firstSteps - coldSteps));
  if (!std::isfinite(growth.cost)) return std::nullopt;
  return growth;
}

}  // namespace thaw
