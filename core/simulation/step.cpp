// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/step.hpp"

#include <cmath>

#include "core/domain/buoyant_force.hpp"
#include "core/domain/sides.hpp"
#include "core/fluid/incompressible/pressure_solver.hpp"
#include "core/heat/heat.hpp"
#include "core/heat/mush.hpp"
#include "core/heat/rest_densities.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/rigid/breaking/break_pieces.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/motion.hpp"
#include "core/rigid/rigidify/deforming.hpp"
#include "core/rigid/rigidify/rigidify.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/body_types/redistribute.hpp"
#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/solid_substeps.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/time/integrate.hpp"
#include "core/simulation/views/rigidify_views.hpp"
#include "core/simulation/views/views.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// First half kick, v += a dt/2, and drift, x += v dt.
void predict(World& w, Halos halos, StepTools& t, double dt, double time) {
  if (w.modules.oriented)
    stepOriented(orientedView(w, t), halos, dt);  // with integrators of their own, and with obstacles at
                                                  // their positions of the force evaluation
  if (w.modules.incompressible) addPressureImpulse(w.particles);  // computed at the end of the last step
  if (w.particles.outsideForce.active)
    recordOutsideKick(w.particles, HalfKick::First, w.scene.domain.gravity, dt, w.ledger);
  if (w.modules.buoyancy) recordBuoyantKick(w.particles, HalfKick::First, w.scene.domain, dt, w.ledger);
  t.mayLeave = kickAndDrift(w, dt, awakeRows(w.modules, w.particles, t.sleep)) || w.clock.substeps > 1;
  if (w.modules.mushDrag) {
    applyMush(heatView(w), 0.5 * dt, dt);
    t.mayLeave = true;
  }
  substepSolids(w, halos, t, dt);  // stiff solids: bonds only, in shorter steps
  if (w.modules.rigid) {
    driftPieces(rigidView(w, t), dt);
    t.mayLeave = true;
  }
  wrapPeriodic(w.grid, w.scene.domain, w.particles, w.ledger.entered.potential);
  moveWalls(w.walls, time);
  t.times.lap(StepPhase::Drift);
  if (w.modules.sheet) {
    moveSheets(sheetView(w), dt);  // exact solution over the step
    t.times.lap(StepPhase::SheetMotion);
  }
}

/// Second half kick with the forces at the new positions, v += a dt/2.
StepOutcome finishKicks(World& w, StepTools& t, double dt) {
  StepOutcome here;
  LargestRates largest;
  if (w.particles.outsideForce.active)
    recordOutsideKick(w.particles, HalfKick::Second, w.scene.domain.gravity, dt, w.ledger);
  if (w.modules.buoyancy) recordBuoyantKick(w.particles, HalfKick::Second, w.scene.domain, dt, w.ledger);
  here.finite = finishKick(w, dt, awakeRows(w.modules, w.particles, t.sleep), &here.bad, &largest);
  here.largest = largest;
  if (w.modules.mushDrag) applyMush(heatView(w), 0.5 * dt, 0);
  if (w.modules.rigid) kickPieces(rigidView(w, t), dt);
  here.badHere = !here.finite || w.oriented.exceededReach;
  if (w.modules.sheet) {
    t.times.lap(StepPhase::Drift);
    kickSheets(sheetView(w), dt);
    t.times.lap(StepPhase::SheetMotion);
  }
  if (w.modules.bodyTypes() && !bodyTypesAreFinite(w)) here.finite = false;
  t.times.lap(StepPhase::Drift);
  return here;
}

/// Advances heat and changes phases.
void heatAndMelt(World& w, StepTools& t, double dt) {
  if (w.modules.heat) updateHeat(heatView(w), dt);  // H += heat dt, T and liquid fraction follow
  if (w.modules.tensionTable) recordTensionChange({wallView(w), t.surface}, t.wallContacts);
  PhaseChanges changes;
  if (w.modules.melting) changes = changePhase(w.scene, w.particles, w.counters);  // solid <-> liquid
  if (w.modules.phaseDensity) updateRestDensities(heatView(w), recordContext(w, t), dt);
  t.phaseChangedHere = changes.melted || changes.frozen;
  t.frozeAnywhere = changes.frozen;  // both are reduced by reduceStep
  if (w.modules.rigidify && findDeforming(rigidifyView(w, t), dt)) t.rigid.changedHere = true;
  t.meltedAnywhere = changes.melted || (t.rigid.changedHere && !w.modules.rigidify);
  t.times.lap(StepPhase::Heat);
}

}  // namespace

void finishPieces(World& w, Halos halos, StepTools& t) {
  const RigidView view = rigidView(w, t);
  if (w.modules.rigidify) {  // contacts are forces
    if (t.rigid.changedHere) rigidifySolids(rigidifyView(w, t), halos);
    t.rigid.changedHere = false;
    return t.times.lap(StepPhase::Contact);
  }
  if (t.meltedAnywhere || t.frozeAnywhere) {
    updatePieces(view, halos, false);
    t.rigid.changedHere = false;
    linkPieces(view, halos, PieceUsers::AndGhosts);
  }
  // At the end of the scene no limit on the step exists.
  const double planned = nextStep(w.clock);
  touchAndBreak(view, halos, std::isfinite(planned) ? planned : w.clock.stepDt);
  t.times.lap(StepPhase::Contact);
}

StepOutcome step(World& w, Halos halos, StepTools& t, Requests wanted) {
  t.times.start();
  const double dt = nextStep(w.clock), time = timeAfter(w.clock, dt);
  predict(w, halos, t, dt, time);
  t.hooks.after(HookPhase::Predict);
  evaluate(w, halos, t, dt);  // forces at the new positions

  if (w.modules.sleep) updateSleep(sleepView(w, t), dt);  // solids at rest are fixed from here on
  const StepOutcome here = finishKicks(w, t, dt);
  t.hooks.after(HookPhase::Integrate);
  heatAndMelt(w, t, dt);
  for (const FieldUpdate& update : t.fieldUpdates) update({w.particles, time, dt});
  t.hooks.after(HookPhase::PhaseChange);

  w.clock.time = time;
  w.clock.stepDt = dt;
  w.clock.step++;
  const StepOutcome all = reduceStep(w, halos, t, here, wanted);
  // Removes compression from v and computes the next density-pressure kick.
  if (w.modules.incompressible && all.finite) solvePressure(w, halos, t, dt);
  if (w.modules.solid && t.meltedAnywhere)
    melt(w, halos, t);  // here and not in the next step, so that checkpoints contain it
  if (w.modules.rigid && all.finite) finishPieces(w, halos, t);
  t.hooks.after(HookPhase::Limits);
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
