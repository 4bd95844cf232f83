// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/step.hpp"

#include "core/domain/sides.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/time/integrate.hpp"
#include "core/simulation/views/views.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// First half kick, v += a dt/2, and drift, x += v dt.
void predict(StepContext& c) {
  World& w = c.w;
  StepTools& t = c.t;
  runPhase(ModulePhase::BeforeMotion, c);
  runPhase(ModulePhase::FirstKick, c);
  t.redistribution.mayLeave = kickAndDrift(w, c.dt, awakeRows(w.modules, w.particles, t.sleep)) ||
                              w.clock.substeps > 1;
  runPhase(ModulePhase::Drift, c);
  wrapPeriodic(w.grid, w.scene.domain, w.particles, w.ledger.entered.potential);
  moveWalls(w.walls, c.time);
  t.times.lap(StepPhase::Drift);
  runPhase(ModulePhase::ObstaclesMoved, c);
}

/// Second half kick with the forces at the new positions, v += a dt/2.
StepOutcome finishKicks(StepContext& c) {
  World& w = c.w;
  StepOutcome here;
  LargestRates largest;
  runPhase(ModulePhase::SecondKick, c);
  here.finite = finishKick(w, c.dt, awakeRows(w.modules, w.particles, c.t.sleep), &here.bad, &largest);
  here.largest = largest;
  runPhase(ModulePhase::Kicked, c);
  here.badHere = !here.finite || c.exceededReach;
  here.finite = bodyTypesAreFinite(w) && here.finite;
  c.t.times.lap(StepPhase::Drift);
  return here;
}

/// Advances heat and changes phases.
void changePhases(StepContext& c) {
  StepTools& t = c.t;
  t.phaseChange.here = t.phaseChange.frozeAnywhere = t.phaseChange.meltedAnywhere = false;
  runPhase(ModulePhase::PhaseChange, c);
  t.times.lap(StepPhase::Heat);
  for (const FieldUpdate& update : t.terms.fieldUpdates) update({c.w.particles, c.time, c.dt});
}

}  // namespace

StepContext stepContext(World& w, Halos halos, StepTools& t, double dt) {
  const WallContext walls{wallView(w),
                          t.walls.tables,
                          t.liquids,
                          dt,
                          dt > 0 ? dt : nextStep(w.clock),
                          1.0 / w.clock.substeps,
                          w.modules.sleep ? &t.sleep.steady : nullptr};
  return {w, halos, t, dt, dt > 0 ? timeAfter(w.clock, dt) : w.clock.time, walls};
}

StepOutcome step(World& w, Halos halos, StepTools& t, Requests requests) {
  t.times.start();
  StepContext c = stepContext(w, halos, t, nextStep(w.clock));
  predict(c);
  t.hooks.after(HookPhase::Predict);
  evaluate(c);  // forces at the new positions
  const StepOutcome here = finishKicks(c);
  t.hooks.after(HookPhase::Integrate);
  changePhases(c);
  t.hooks.after(HookPhase::PhaseChange);

  w.clock.time = c.time;
  w.clock.stepDt = c.dt;
  w.clock.step++;
  const StepOutcome all = reduceStep(c, here, requests);  // the next step
  c.finite = all.finite;
  runPhase(ModulePhase::EndOfStep, c);
  t.hooks.after(HookPhase::EndOfStep);
  return all;
}

double totalMass(const Continuum& p, Reducer& all) {
  ExactSum mass;
  for (std::size_t i = 0; i < p.owned; i++) mass.add(p.mass[i]);
  mass.carry();
  all.sum(mass.digit);
  return mass.value();
}

}  // namespace thaw
