// SPDX-License-Identifier: Apache-2.0
// The end of a step: limits, failures and requests of all ranks.
#include <algorithm>

#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/step.hpp"
#include "core/simulation/step_context.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Collects limits, failures and requests of this rank.
void reductionHere(StepContext& c, const StepOutcome& here, Requests requests) {
  World& w = c.w;
  StepTools& t = c.t;
  StepLimits& own = c.limits;
  own = particleLimits(w, here.largest ? *here.largest : largestRates(w.particles),
                       t.limits.stableViscousStep);
  // The minimum over ranks is the limit of the most compressed particle.
  own[Limit::Sound] = t.limits.fixed[Limit::Sound] / soundStiffening(w.scene, w.modules, w.particles);
  // Wall contacts are stiffer than the lattice behind cfl_sound. The factor limits omega dt to 1.2; values up
  // to 2 are stable.
  if (t.walls.contacts.stiffest > 0)
    own[Limit::Contact] = 3 * w.scene.numerics.cflSound / t.walls.contacts.stiffest;
  StepReduction& reduction = c.reduction;
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    reduction.negatedLimits[k] = -std::min(t.limits.fixed.value[k], own.value[k]);
  if (mayBeDry(w.scene, w.modules) && isDry(w.particles))
    for (const Limit l : limitsOfLiquid) reduction.negatedLimits[static_cast<std::size_t>(l)] = -never;
  reduction.froze = t.phaseChange.frozeAnywhere;
  reduction.melted = t.phaseChange.meltedAnywhere;
  reduction.bad = here.badHere || !here.finite;
  reduction.stop = requests.stop;
  reduction.report = requests.report;
  reduction.checkpoint = requests.checkpoint;
  runPhase(ModulePhase::Limits, c);
}

/// Computes the limits of all ranks.
void limitsOfAll(StepContext& c) {
  StepLimits& limits = c.commonLimits;
  limits = c.t.limits.fixed;
  const StepReduction& reduction = c.reduction;
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    limits.value[k] = -reduction.negatedLimits[k];
  for (std::size_t k = 0; k < bodyTypeLimits; k++)
    limits.value[reduction.negatedLimits.size() + k] = -reduction.negatedBodyTypeLimits[k];
  runPhase(ModulePhase::CommonLimits, c);
}

/// Sets the next step in the clock.
void setNextStep(MonitorState& monitor, const Scene& scene, Clock& clock, StepLimits limits,
                 Limit limitedBy) {
  monitor.factor = nextFactor(monitor);  // 1, or less after a rollback
  const double fixed = scene.numerics.fixedStep, factor = monitor.factor;
  // Without a limit, only frames shorten the step. After a rollback, the step is a fraction of the longest
  // such step.
  const bool limited = limits[limitedBy] < never;
  const double limit = limited || factor == 1 ? limits[limitedBy] : longestUnlimitedStep(clock);
  // The step grows by at most a tenth: fluctuating leap-frog steps pump energy into fast oscillations.
  clock.dt = fixed > 0 ? factor * fixed : std::min(factor * limit, clock.step > 0 ? 1.1 * clock.dt : never);
  clock.limitedBy = fixed > 0 ? "the scene's fixed step"
                    : limited ? limitNames[static_cast<std::size_t>(limitedBy)]
                              : "frames";
}

}  // namespace

StepOutcome reduceStep(StepContext& c, StepOutcome here, Requests requests) {
  World& w = c.w;
  StepTools& t = c.t;
  reductionHere(c, here, requests);
  t.times.lap(StepPhase::Drift);
  reduceOverRanks(c.reduction, c.halos.all, w.modules);
  t.times.lap(StepPhase::Reduce);
  const StepReduction& reduction = c.reduction;
  limitsOfAll(c);
  StepOutcome all = here;
  all.limitedBy = c.commonLimits.smallest();
  t.phaseChange.frozeAnywhere = reduction.froze > 0;
  t.phaseChange.meltedAnywhere = reduction.melted > 0;
  all.finite = !(reduction.bad > 0);
  all.requests = {reduction.stop > 0, reduction.report > 0, reduction.checkpoint > 0};
  all.surfaceMove2 = reduction.surfaceMove2;
  all.failure = all.finite ? failureOf(w, t.limits.monitor, c.commonLimits, reduction.relativeDensity)
                           : Failure::NotFinite;
  setNextStep(w.monitor, w.scene, w.clock, c.commonLimits, all.limitedBy);
  runPhase(ModulePhase::NextStep, c);
  return all;
}

StepOutcome reduceStep(World& w, Halos halos, StepTools& t, StepOutcome here, Requests requests) {
  StepContext c = stepContext(w, halos, t, 0);
  return reduceStep(c, here, requests);
}

}  // namespace thaw
