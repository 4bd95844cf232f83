// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/step.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/solid_contact.hpp"
#include "core/domain/sides.hpp"
#include "core/fluid/density/carried_density.hpp"
#include "core/fluid/incompressible/pressure_solver.hpp"
#include "core/heat/heat.hpp"
#include "core/oriented/forces/continuum_contact.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/body_types/redistribute.hpp"
#include "core/simulation/ledger/energy_left.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/redistribute.hpp"
#include "core/simulation/solid_substeps.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/time/integrate.hpp"
#include "core/simulation/time/step_reduction.hpp"
#include "core/simulation/world/views.hpp"
#include "core/surface/surface_due.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {

StepOutcome step(World& w, Halos halos, StepTools& t, Requests wanted) {
  t.times.start();
  const double dt = nextStep(w.clock), time = timeAfter(w.clock, dt);
  if (w.modules.oriented)
    stepOriented(orientedView(w, t), halos, dt);  // with integrators of their own, and with obstacles at
                                                  // their positions of the force evaluation
  if (w.modules.incompressible) addPressureImpulse(w.particles);  // computed at the end of the last step
  // v += a dt/2, x += v dt
  t.mayLeave = kickAndDrift(w, dt, awakeRows(w.modules, w.particles, t.sleep)) || w.clock.substeps > 1;
  substepSolids(w, halos, t, dt);  // stiff solids: bonds only, in shorter steps
  wrapPeriodic(w.grid, w.scene.domain, w.particles, w.ledger.entered.potential);
  moveWalls(w.walls, time);
  t.times.lap(StepPhase::Drift);
  if (w.modules.sheet) {
    moveSheets(sheetView(w), dt);  // exact solution over the step
    t.times.lap(StepPhase::SheetMotion);
  }

  evaluate(w, halos, t, dt);  // forces at the new positions

  if (w.modules.sleep) updateSleep(sleepView(w, t), dt);  // solids at rest are fixed from here on
  StepOutcome here;
  LargestRates largest;
  // v += a dt/2
  here.finite = finishKick(w, dt, awakeRows(w.modules, w.particles, t.sleep), &here.bad, &largest);
  here.largest = largest;
  here.badHere = !here.finite || w.oriented.exceededReach;
  if (w.modules.sheet) {
    t.times.lap(StepPhase::Drift);
    kickSheets(sheetView(w), dt);  // v += impulse of forces at the new positions
    t.times.lap(StepPhase::SheetMotion);
  }
  if (w.modules.kinds() && !bodyTypesAreFinite(w)) here.finite = false;
  t.times.lap(StepPhase::Drift);
  if (w.modules.heat) updateHeat(heatView(w), dt);  // H += heat dt, T and liquid fraction follow
  PhaseChanges changes;
  if (w.modules.melting) changes = changePhase(w.scene, w.particles, w.counters);  // solid <-> liquid
  t.phaseChangedHere = changes.melted || changes.frozen;
  t.frozeAnywhere = changes.frozen;  // both are reduced by reduceStep
  t.meltedAnywhere = changes.melted;
  t.times.lap(StepPhase::Heat);

  w.clock.time = time;
  w.clock.stepDt = dt;
  w.clock.step++;
  const StepOutcome all = reduceStep(w, halos, t, here, wanted);
  // Removes compression from v and computes the next density-pressure kick.
  if (w.modules.incompressible && all.finite) solvePressure(w, halos, t, dt);
  if (w.modules.solid && t.meltedAnywhere)
    melt(w, halos, t);  // here and not in the next step, so that checkpoints contain it
  return all;
}

void evaluate(World& w, Halos halos, StepTools& t, double dt) {
  Continuum& p = w.particles;
  const bool leftSlots = redistribute(w, halos, t, dt);  // emit, remove, migrate, sort by (cell, id)
  if (w.modules.solid)
    rebuildSolidBonds(w, halos, t, {{}, t.phaseChangedHere || leftSlots || t.bondsAtStart});
  t.phaseChangedHere = false;
  if (w.modules.kinds()) redistributeBodyTypes(w, halos, t, dt);
  if (w.modules.sheet) linkSheets(w.sheets, halos, t.times);
  if (w.modules.oriented) evaluateOriented(orientedView(w, t), halos, dt);

  // First, since it projects particles out of walls: ghosts and bonds must use the new positions.
  const WallContext walls{wallView(w),
                          t.wallTables,
                          t.liquids,
                          dt,
                          dt > 0 ? dt : nextStep(w.clock),
                          1.0 / w.clock.substeps,
                          w.modules.sleep ? &t.sleep.steady : nullptr};
  findWallContacts(walls, t.wallContacts);
  t.times.lap(StepPhase::Walls);

  if (w.modules.sleep) beginSleep(sleepView(w, t), dt);
  const std::int64_t coincident = w.counters.coincidentPairs;
  const bool neighbours = needsNeighbours(w, t);
  // Start the exchange of surrounding cells ...
  if (neighbours) halos.cells.beginGhosts(p, w.cells, ghostColumns(w));
  if (w.modules.solid) beginDeformation(w, halos, t);
  t.times.lap(StepPhase::Exchange);
  clearRates(w, w.modules.uniform);
  // An evaluation with new coefficients records the jump of all contacts.
  const bool justFrozen = t.frozeAnywhere && w.modules.freezing && dt > 0;
  if (neighbours) {
    if (w.modules.continuity) beginCarry(carryContext(w, t, dt));
    markInner(w, halos.cells, t);
    if (w.modules.sleep) markSleepingInner(sleepView(w, t));
    sumOverNeighbours(w, t, NeighbourPass::InnerDensity, dt);  // ... while inner particles are searched and
                                                               // summed
    halos.cells.finishGhosts(p, w.cells);
    t.times.lap(StepPhase::Exchange);
    markInner(w, halos.cells, t);
    if (w.modules.sleep) markSleeping(sleepView(w, t));
    sumOverNeighbours(w, t, NeighbourPass::BoundaryDensity, dt);
  }
  if (w.modules.sleep) dropSkippedContacts(t.sleep, t.wallContacts);
  if (w.modules.fluid && !w.modules.continuity)
    addWallRelativeDensity(walls, t.perLatticeSum, t.wallContacts);
  t.times.lap(StepPhase::Walls);

  if (w.modules.continuity && neighbours) finishCarry(carryContext(w, t, dt));
  if (w.modules.shifting && !w.modules.continuity) shiftInside(carryContext(w, t, dt));
  if (w.modules.surfaceEnergy) findSurfaceEnergy(walls, t.surface, t.wallContacts);
  if (w.modules.tension) recordEnergyLeft(w, t);
  ColumnList toGhosts{&p.relativeDensity};
  if (p.correction.active) toGhosts.push_back(&p.correction);
  if (p.relief.active) toGhosts.push_back(&p.relief);
  if (w.modules.surfaceEnergy) {
    toGhosts.push_back(&p.surfaceEnergyByGradient);
    toGhosts.push_back(&p.surfaceEnergyByColour);
  }
  if (w.modules.fluid) halos.cells.beginRefresh(p, toGhosts);
  t.times.lap(StepPhase::Exchange);
  if (w.modules.solid) deform(w, halos, t, dt);  // F, stress; bonds break, form, take new references
  // Pressure, viscosity, heat, tension.
  if (w.modules.neighbours) sumOverNeighbours(w, t, NeighbourPass::InnerForces);
  if (w.modules.fluid) halos.cells.finishRefresh(p);
  t.times.lap(StepPhase::Exchange);
  if (w.modules.neighbours) sumOverNeighbours(w, t, NeighbourPass::BoundaryForces);
  if (p.softening.active && w.modules.fluid)
    beginSoftening(w, t);  // derivative of pair and contact energies with respect to the liquid fraction
  if (w.modules.solid) addElasticForces(w, halos, t, dt);
  if (w.modules.contact)
    addSolidContacts(
        {w.scene, w.grid, w.solids, w.bonds, walls.span, justFrozen ? &w.ledger.phaseJump : nullptr,
         &t.contactResistance, w.modules.fluid ? nullptr : &w.counters.coincidentPairs},
        t.closePairs, p);
  t.times.lap(StepPhase::Contact);
  if (w.modules.sleep) recordConstraintForces(p, w.scene, t.sleep);
  addWallForces(walls, t.perLatticeSum, t.wallContacts);
  t.times.lap(StepPhase::Walls);
  if (w.modules.sheet)
    loadSheets(sheetView(w), halos, t.times, dt);  // forces on vertices, and of vertices on particles
  if (w.modules.orientedContact)
    addContinuumContact(orientedView(w, t), dt);  // oriented particles and the continuum
  if (w.modules.oriented)
    recordBirthContacts(w.oriented.rows, t.oriented, w.ledger);  // contacts of particles born in this step
  if (w.modules.contact) recordResistance(walls, t.contactResistance);
  recordClamps(walls, t.wallContacts);
  if (w.modules.implicitViscosity) solveViscosity(w, halos, t, walls);  // needs all other forces
  if (w.modules.heat) {
    addWallHeat(walls, t.wallContacts);
    addOuterHeat(heatView(w), dt, walls.steady);
    addThermostats(heatView(w), dt);
  }
  if (w.modules.neighbours) separateCoincident(w, t, coincident);
  t.times.lap(StepPhase::Heat);
}

StepOutcome reduceStep(World& w, Halos halos, StepTools& t, StepOutcome here, Requests wanted) {
  StepLimits limits = t.fixedLimits;
  StepLimits own = particleLimits(w, here.largest ? *here.largest : largestRates(w), t.stableViscousStep);
  own[Limit::Sound] = limits[Limit::Sound] / soundStiffening(w);  // the minimum over ranks belongs to the
                                                                  // most compressed particle
  // The push of a wall is stiffer than the lattice to which cfl_sound refers: omega dt is at most 1.2 (2 is
  // stable).
  if (t.wallContacts.stiffest > 0)
    own[Limit::Contact] = 3 * w.scene.numerics.cflSound / t.wallContacts.stiffest;
  StepReduction reduction;
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    reduction.negatedLimits[k] = -std::min(limits.value[k], own.value[k]);
  if (w.modules.kinds())
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
  if (w.modules.solid) reduction.strainBound = largestStrainBound(t.elastic, w.solids);
  if (w.modules.substeps) reduction.negatedFastLimit = -fastAccelerationLimit(w);
  if (w.modules.fluid) reduction.relativeDensity = largestRelativeDensity(w);
  if (w.modules.surface) reduction.surfaceMove2 = largestSurfaceMove2(w.grid, w.particles, w.surface);
  // Bonds break and references change in any step.
  if (w.modules.solid) w.counters.singularNeighbourhoods = countSingular(t.elastic, w.solids);
  t.times.lap(StepPhase::Drift);
  reduceOverRanks(reduction, halos.all, w.modules);
  t.times.lap(StepPhase::Reduce);
  for (std::size_t k = 0; k < reduction.negatedLimits.size(); k++)
    limits.value[k] = -reduction.negatedLimits[k];
  for (std::size_t k = 0; k < bodyTypeLimits && w.modules.kinds(); k++)
    limits.value[reduction.negatedLimits.size() + k] = -reduction.negatedBodyTypeLimits[k];
  // From the largest values of all ranks: the minimum of their limits would depend on the partition.
  if (w.modules.solid)
    limits[Limit::Elastic] = elasticStepLimit(w.scene, reduction.stretch2, reduction.strainBound);
  // Limit of a substep.
  const double longest = std::min({limits[Limit::Elastic], t.longestContact, -reduction.negatedFastLimit});
  if (w.modules.substeps) limits[Limit::Elastic] = w.modules.mostSubsteps * longest;
  StepOutcome all = here;
  all.limitedBy = limits.smallest();
  t.frozeAnywhere = reduction.froze > 0;
  t.meltedAnywhere = reduction.melted > 0;
  all.finite = !(reduction.bad > 0);
  all.wanted = {reduction.stop > 0, reduction.report > 0, reduction.checkpoint > 0};
  all.surfaceMove2 = reduction.surfaceMove2;
  all.failure = all.finite ? failureOf(w, t.watch, limits, reduction.relativeDensity) : Failure::NotFinite;
  w.watch.factor = nextFactor(w.watch);  // 1, or less after a rollback
  const double fixed = w.scene.numerics.fixedStep, factor = w.watch.factor;
  // Without a limit frames shorten the step; after a rollback it is a fraction of that.
  const bool limited = limits[all.limitedBy] < never;
  const double limit = limited || factor == 1 ? limits[all.limitedBy] : longestUnlimitedStep(w.clock);
  // The step grows by at most a tenth: fluctuating leap-frog steps pump energy into fast oscillations.
  w.clock.dt = fixed > 0 ? factor * fixed
                         : std::min(factor * limit, w.clock.step > 0 ? 1.1 * w.clock.dt : never);
  if (w.modules.substeps) chooseSubsteps(w, t, factor * longest);
  w.clock.limitedBy = fixed > 0 ? "the scene's fixed step"
                      : limited ? limitNames[static_cast<std::size_t>(all.limitedBy)]
                                : "frames";
  return all;
}

double totalMass(const World& w, Reducer& all) {
  ExactSum mass;
  for (std::size_t i = 0; i < w.particles.owned; i++) mass.add(w.particles.mass[i]);
  mass.carry();
  all.sum(mass.digit);
  return mass.value();
}

}  // namespace thaw
