// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/setup.hpp"

#include <algorithm>
#include <iterator>

#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/sleeping_pieces.hpp"
#include "core/simulation/body_types/cell_costs.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/setup/relax_oriented.hpp"
#include "core/simulation/setup/warnings/compressed_liquid.hpp"
#include "core/simulation/setup/warnings/fixed_step.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/simulation/views/views.hpp"
#include "core/solid/elasticity/active_solids.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/walls.hpp"

namespace thaw {
namespace {

/// Computes forces and accelerations at the current positions, without a preceding step.
void evaluateNow(World& w, Halos halos, StepTools& t) {
  Continuum& p = w.particles;
  evaluate(w, halos, t, 0);
  for (std::size_t i = 0; i < p.owned; i++)
    p.acceleration[i] = p.force[i] / p.mass[i] + w.scene.domain.gravity;
  if (p.clamped.active)
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.clamped[i]) p.acceleration[i] = {};
}

/// Prepares the first step in the same way as the end of a step prepares the next one.
void prepareNextStep(World& w, Halos halos, StepTools& t) {
  StepContext c = stepContext(w, halos, t, 0);
  runPhase(ModulePhase::EndOfStep, c);
}

/// Adds `sign` times the stored energy (J) of this rank to `to`, including the part that symplectic Euler has
/// not yet converted.
void recordStored(World& w, StepTools& t, double sign, ExactSum& to) {
  const ExactBalance here = balanceHere(w);
  to.addProduct(here.elastic, sign);
  to.addProduct(here.potential, sign);
  if (w.modules.oriented) recordKickLag(orientedView(w, t), sign, w.clock.stepDt, to);
}

/// Frees the buffers of the first sorts, since these covered all rows.
void dropBuffersOfStart(Continuum& particles, SortBuffers& sort) {
  particles.shrink();
  sort = {};
  trimFreedMemory();
}

/// As initializeForces(). Returns the limits (s) of the first step.
StepLimits initializeWithLimits(World& w, Halos halos, StepTools& t) {
  Continuum& p = w.particles;
  t.times.start();
  const double fixed = w.scene.numerics.fixedStep;
  // Used until particle limits are known.
  w.clock.dt = fixed > 0 ? fixed : t.limits.fixed[t.limits.fixed.smallest()];
  if (fieldsDeferred(w.bonds, t.solid))
    for (AnyColumn* c : columnsOfSteps(w.solids, t.solid.elastic)) w.solids.deactivate(*c);
  evaluateNow(w, halos, t);
  if (!w.modules.neighbours) {  // lists were only needed for the initial bonds
    w.neighbours = {};
    t.sums.records = {};
    t.sums.search = {};
  }
  dropBuffersOfStart(w.particles, t.redistribution.sort);
  t.mass = totalMass(w.particles, halos.all);
  const LedgerReport now = reportLedger(w, t, halos.all);
  w.ledger.initial = now.now;
  // Particles emitted at time 0, and gains and losses of relaxation, belong to the initial state.
  w.ledger.entered = w.ledger.left = {};
  StepContext c = stepContext(w, halos, t, 0);
  reduceStep(c, {}, {});
  const double half = 0.5 * nextStep(w.clock);  // the first half kick, which no step records
  for (std::size_t i = 0; i < p.owned; i++) p.dissipated[i] = p.dissipation[i] * half;
  prepareNextStep(w, halos, t);  // dissipates the part of the initial velocities that would compress liquids
  return c.commonLimits;
}

}  // namespace

void initializeForces(World& w, Halos halos, StepTools& t) { initializeWithLimits(w, halos, t); }

SamplingReport startWorld(World& w, Halos halos, StepTools& t, const MeshLoader& load,
                          const ParticleChange& change) {
  SamplingReport report = sampleWorld(w, halos, t, load);
  if (change) change(w.particles);
  if (w.modules.oriented) t.oriented.relaxed = relaxOriented(w, halos, t);
  t.solid.bondsAtStart = w.modules.solid;
  t.rigid.atStart = w.modules.rigid && !w.modules.rigidify;
  t.sources.emitFirst = true;
  const StepLimits limits = initializeWithLimits(w, halos, t);
  std::ranges::move(compressedLiquids(w, t.liquids, halos.all), std::back_inserter(report.warnings));
  std::ranges::move(longFixedStep(w.scene, nextStep(w.clock), limits), std::back_inserter(report.warnings));
  w.initialSummedDensity = {};
  return report;
}

void resumeWorld(World& w, Halos halos, StepTools& t) {
  Continuum& p = w.particles;
  t.times.start();
  moveWalls(w.walls, w.clock.time);
  t.sources.shapes = {};
  t.sleep = {};
  forgetActiveSolids(t.solid.elastic);
  w.solids.energyKnown = w.interactionHasCompression = true;  // part of the state
  if (p.solidIndex.active) {
    for (std::size_t i = 0; i < p.owned; i++) p.solidIndex[i] = noSolid;
    rebuildSolidBonds(w, halos, t, {{}, true});  // creates the solids of the records on the rank that read
                                                 // them
  }
  computeCellKeys(w.grid, p);
  Migration all;
  all.arrivals = p.owned;
  sortByCell(p, all, t.redistribution.sort, w.cells);
  forEachBodyType(w, [&](std::size_t, BodyTypeRows& r, CellTable& cells) {
    computeCellKeys(w.grid, r);
    Migration fresh;
    fresh.arrivals = r.owned;
    sortByCell(r, fresh, t.redistribution.sort, cells);
  });
  if (w.modules.rigid) {
    t.rigid = {};
    t.rigid.departed.assign(w.pieces.id.data(), w.pieces.id.data() + w.pieces.owned);
    linkPieces(rigidView(w, t.rigid), halos, PieceUsers::Owned);
  }
  const CellCosts costs = countCells(w);
  halos.cells.rebalance(costs.cells, costs.cost, true);
  t.redistribution.newPartition = true;
  // After the exchange of ghosts, body types equal the state of the last step.
  if (w.modules.bodyTypes()) redistributeBodyTypes(w, halos, t.redistribution);
  if (w.modules.oriented) updateNeighbours(w.oriented, w.scene, halos, t.oriented.lists);
  t.oriented.time = w.clock.time;
  dropBuffersOfStart(w.particles, t.redistribution.sort);
  t.mass = totalMass(w.particles, halos.all);
  double froze = 0;
  if (p.justFrozen.active)
    for (std::size_t i = 0; i < p.owned; i++) froze = p.justFrozen[i] ? 1 : froze;
  halos.all.maximum({&froze, 1});
  t.phaseChange.frozeAnywhere = froze > 0;
  t.phaseChange.here = true;
  // A resumed scene with a shorter step limit applies the limit to the first step, too. For the same scene,
  // no bit changes.
  const double fixed = w.scene.numerics.fixedStep, factor = w.monitor.factor;
  StepLimits limits = t.limits.fixed;
  if (w.modules.substeps)
    limits[Limit::Elastic] = w.modules.mostSubsteps *
                             std::min(limits[Limit::Elastic], t.limits.longestContact);
  if (mayBeDry(w.scene, w.modules)) {
    double hasLiquid = isDry(p) ? 0 : 1;
    halos.all.maximum({&hasLiquid, 1});
    if (hasLiquid == 0)
      for (const Limit l : limitsOfLiquid) limits[l] = never;
  }
  // The current step of rigid parts may be longer. These limits apply from the next step on.
  if (w.modules.rigidify) limits[Limit::Elastic] = limits[Limit::Contact] = never;
  w.clock.dt = fixed > 0 ? factor * fixed : std::min(w.clock.dt, factor * limits[limits.smallest()]);
}

void applyNewCoefficients(World& w, Halos halos, StepTools& t) {
  ExactSum jump;
  findStoredEnergy(w, t);
  recordStored(w, t, -1, jump);
  if (w.modules.oriented) applyPendingImpulse(w.oriented.rows, w.clock, w.ledger);
  if (w.modules.sleep) wakeEverything(w.particles);
  if (w.modules.pieceSleep) wakePieces(w.pieces);
  evaluateNow(w, halos, t);
  findStoredEnergy(w, t);
  recordStored(w, t, 1, jump);
  w.ledger.restartJump += jump;
  t.phaseChange.frozeAnywhere = false;  // newly frozen particles already have bonds
  StepContext c = stepContext(w, halos, t, 0);
  c.contactNear = w.modules.rareContact;  // unknown here; assume contact, since a new stiffness may shorten
                                          // the limit
  reduceStep(c, {}, {});
  prepareNextStep(w, halos, t);
}

}  // namespace thaw
