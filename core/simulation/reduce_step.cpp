// SPDX-License-Identifier: Apache-2.0
// The end of a step: limits, failures and requests of all ranks.
#include <algorithm>

#include "core/heat/sources/heat_sources.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/rigid/rigidify/deforming.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/solid_substeps.hpp"
#include "core/simulation/step.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/time/step_reduction.hpp"
#include "core/simulation/views/rigidify_views.hpp"
#include "core/surface/surface_due.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Values of this rank.
StepReduction reductionHere(World& w, StepTools& t, const StepOutcome& here, Requests wanted) {
  StepLimits own = particleLimits(w, here.largest ? *here.largest : largestRates(w.particles),
                                  t.stableViscousStep);
  own[Limit::Sound] = t.fixedLimits[Limit::Sound] / soundStiffening(w);  // the minimum over ranks belongs to
                                                                         // the most compressed particle
  // Neighbourhoods that tear are stiffer than a lattice, and begin to oscillate from step to step.
  if (t.carry.largestChange > 0 && w.clock.stepDt > 0)
    own[Limit::Density] = w.clock.stepDt * densityChangePerStep / t.carry.largestChange;
  // Wall contacts are stiffer than the lattice behind cfl_sound. Here omega dt is at most 1.2; 2 is stable.
  if (t.wallContacts.stiffest > 0)
    own[Limit::Contact] = 3 * w.scene.numerics.cflSound / t.wallContacts.stiffest;
  if (w.modules.lamps) own[Limit::Heat] = std::min(own[Limit::Heat], sourceStepLimit(w.scene, w.clock.time));
  StepReduction reduction;
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    reduction.negatedLimits[k] = -std::min(t.fixedLimits.value[k], own.value[k]);
  if (w.modules.bodyTypes())
    reduction.negatedBodyTypeLimits = {
        w.modules.oriented ? -orientedStepLimit(w.oriented.rows, w.scene, t.oriented) : -never,
        w.modules.sheet ? -sheetStepLimit(w.sheets, w.scene, w.clock) : -never};
  reduction.froze = t.frozeAnywhere;
  reduction.melted = t.meltedAnywhere;
  reduction.bad = here.badHere || !here.finite;
  reduction.stop = wanted.stop;
  reduction.report = wanted.report;
  reduction.checkpoint = wanted.checkpoint;
  if (w.modules.solid) reduction.stretch2 = t.maxStretch2;
  reduction.rigidity = w.modules.rigidify && t.rigid.changedHere;
  if (w.modules.rigidify && nothingDeforms(rigidifyView(w, t))) {
    reduction.stretch2 = 0;
    reduction.negatedLimits[static_cast<std::size_t>(Limit::Contact)] = -own[Limit::Contact];
  }
  if (w.modules.solid) reduction.strainBound = largestStrainBound(t.elastic, w.solids);
  if (w.modules.substeps) reduction.negatedFastLimit = -fastAccelerationLimit(w);
  if (w.modules.fluid) reduction.relativeDensity = largestRelativeDensity(w.particles);
  if (w.modules.surface) reduction.surfaceMove2 = largestSurfaceMove2(w.grid, w.particles, w.surface);
  return reduction;
}

/// Limits of all ranks. longest: limit of a substep.
StepLimits limitsOfAll(const World& w, const StepTools& t, const StepReduction& reduction, double& longest) {
  StepLimits limits = t.fixedLimits;
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    limits.value[k] = -reduction.negatedLimits[k];
  for (std::size_t k = 0; k < bodyTypeLimits && w.modules.bodyTypes(); k++)
    limits.value[reduction.negatedLimits.size() + k] = -reduction.negatedBodyTypeLimits[k];
  // From the largest values of all ranks: the minimum of their limits would depend on the partition.
  if (w.modules.solid)
    limits[Limit::Elastic] = reduction.stretch2 > 0
                                 ? elasticStepLimit(w.scene, reduction.stretch2, reduction.strainBound)
                                 : never;
  longest = std::min({limits[Limit::Elastic], t.longestContact, -reduction.negatedFastLimit});
  if (w.modules.substeps) limits[Limit::Elastic] = w.modules.mostSubsteps * longest;
  return limits;
}

/// Sets the next step in the clock.
void setNextStep(World& w, StepLimits limits, Limit limitedBy) {
  w.watch.factor = nextFactor(w.watch);  // 1, or less after a rollback
  const double fixed = w.scene.numerics.fixedStep, factor = w.watch.factor;
  // Without a limit frames shorten the step; after a rollback it is a fraction of that.
  const bool limited = limits[limitedBy] < never;
  const double limit = limited || factor == 1 ? limits[limitedBy] : longestUnlimitedStep(w.clock);
  // The step grows by at most a tenth: fluctuating leap-frog steps pump energy into fast oscillations.
  w.clock.dt = fixed > 0 ? factor * fixed
                         : std::min(factor * limit, w.clock.step > 0 ? 1.1 * w.clock.dt : never);
  w.clock.limitedBy = fixed > 0 ? "the scene's fixed step"
                      : limited ? limitNames[static_cast<std::size_t>(limitedBy)]
                                : "frames";
}

}  // namespace

StepOutcome reduceStep(World& w, Halos halos, StepTools& t, StepOutcome here, Requests wanted) {
  StepReduction reduction = reductionHere(w, t, here, wanted);
  // Bonds break and references change in any step.
  if (w.modules.solid) w.counters.singularNeighbourhoods = countSingular(t.elastic, w.solids);
  t.times.lap(StepPhase::Drift);
  reduceOverRanks(reduction, halos.all, w.modules);
  t.times.lap(StepPhase::Reduce);
  double longest = never;
  StepLimits limits = limitsOfAll(w, t, reduction, longest);
  StepOutcome all = here;
  all.limitedBy = limits.smallest();
  t.frozeAnywhere = reduction.froze > 0;
  t.meltedAnywhere = reduction.melted > 0;
  if (w.modules.rigidify) t.rigid.changedHere = reduction.rigidity > 0;  // anywhere
  all.finite = !(reduction.bad > 0);
  all.wanted = {reduction.stop > 0, reduction.report > 0, reduction.checkpoint > 0};
  all.surfaceMove2 = reduction.surfaceMove2;
  all.failure = all.finite ? failureOf(w, t.watch, limits, reduction.relativeDensity) : Failure::NotFinite;
  setNextStep(w, limits, all.limitedBy);
  if (w.modules.substeps) chooseSubsteps(w, t, w.watch.factor * longest);
  return all;
}

}  // namespace thaw
