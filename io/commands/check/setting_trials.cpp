// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/setting_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/simulation/ledger/report.hpp"
#include "core/time/seconds_now.hpp"
#include "io/run/failure_text.hpp"
#include "io/scene/scene_for_all.hpp"
#include "parallel/mpi_simulation.hpp"

namespace thaw {
namespace {

constexpr double mostParticleSteps = 1e6;  // per run: a second or two on one core
constexpr int leastSteps = 20,
              mostSteps = 250;        // fewer show nothing; more take long with few particles
constexpr double mostSeconds = 15;    // all runs together
constexpr double unexplained = 0.05;  // allowed increase of the residual by the setting, as a fraction of the
                                      // largest term of the ledger

}  // namespace

void startTrial(MpiSimulation& simulation, const Communicator& comm, const TriedScene& scene,
                const std::vector<std::string>& settings) {
  std::vector<std::string> overrides = scene.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  Scene& s = simulation.world.scene;
  s = sceneForAll(comm, scene.path, overrides);
  s.surface.on = false;
  for (OrientedBody& b : s.oriented) b.relax = 0;
  simulation.prepare(meshLoader());
  simulation.start(meshLoader());
}

SettingTrials::SettingTrials(const Communicator& comm, TriedScene scene)
    : comm_(comm), scene_(std::move(scene)), start_(secondsNow()) {
  const double steps = mostParticleSteps / std::max(1.0, scene_.particles);
  steps_ = steps < leastSteps ? 0 : static_cast<int>(std::min<double>(steps, mostSteps));
}

bool SettingTrials::outOfTime() const {
  int over = secondsNow() - start_ > mostSeconds;
  MPI_Bcast(&over, 1, MPI_INT, 0, comm_.handle());
  return over != 0;
}

SettingTrials::Result SettingTrials::runWith(const std::vector<std::string>& settings) {
  Result r;
  MpiSimulation simulation(comm_);
  World& w = simulation.world;
  StepTools& t = simulation.tools;
  startTrial(simulation, comm_, scene_, settings);
  for (int n = 0; n < steps_ && w.clock.time < w.clock.end; n++) {
    StepOutcome o = simulation.step();
    const bool last = n + 1 == steps_ || w.clock.time >= w.clock.end;
    LedgerReport ledger;
    if (last && o.failure == Failure::None) {
      ledger = reportLedger(w, t, simulation.all);
      o.failure = checkEnergyBudget(w, t.limits.monitor, ledger, simulation.all);
    }
    if (o.failure != Failure::None) {
      r.failure = fmt::format("step {}: {}", w.clock.step, failedCheck(w, t, o));
      return r;
    }
    if (last)
      r = {"", ledger.energyResidual, std::max(ledger.energyScale, ledger.energyRounding), w.counters.left,
           ledger.particles};
  }
  simulation.all.sum({&r.left, 1});
  return r;
}

std::optional<std::string> SettingTrials::failureOf(const std::vector<std::string>& settings) {
  if (steps_ == 0 || outOfTime()) return std::nullopt;
  if (!usual_) usual_ = runWith({});
  if (!usual_->failure.empty()) return "the scene also fails without it; " + usual_->failure;
  if (outOfTime()) return std::nullopt;
  Result r;
  try {
    r = runWith(settings);
  } catch (const std::runtime_error& e) {  // set-up fails alike on all ranks
    return fmt::format("refused: {}", e.what());
  }
  if (!r.failure.empty()) return r.failure;
  const double scale = std::max(r.scale, usual_->scale), more = r.residual - std::max(0.0, usual_->residual);
  if (more > unexplained * scale)
    return fmt::format("unexplained energy after {} steps, {:.0f} % of the largest term of the ledger",
                       steps_, 100 * more / scale);
  if (const std::int64_t lost = r.left - usual_->left;
      static_cast<double>(lost) > 1e-3 * static_cast<double>(usual_->particles))
    return fmt::format("{} more particles leave the domain in {} steps", lost, steps_);
  return "";
}

}  // namespace thaw
