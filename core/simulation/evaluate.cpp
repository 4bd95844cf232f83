// SPDX-License-Identifier: Apache-2.0
// The phases of an evaluation of all forces, in their order.
#include <utility>

#include "core/contact/solid_contact.hpp"
#include "core/domain/buoyant_force.hpp"
#include "core/fluid/density/carried_density.hpp"
#include "core/fluid/rheology/apparent_viscosity.hpp"
#include "core/heat/evaporation.hpp"
#include "core/heat/heat.hpp"
#include "core/heat/mush.hpp"
#include "core/heat/sources/heat_sources.hpp"
#include "core/oriented/forces/continuum_contact.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/motion.hpp"
#include "core/rigid/rigidify/loads.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/body_types/redistribute.hpp"
#include "core/simulation/ledger/energy_left.hpp"
#include "core/simulation/redistribute.hpp"
#include "core/simulation/step.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/views/rigidify_views.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/vanished_walls.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// One evaluation.
struct Evaluation {
  World& w;
  Halos halos;
  StepTools& t;
  double dt;  ///< s, last step, 0 at the start
  WallContext walls;
  bool neighbours = false;  ///< some sum over neighbours is needed
  Exchange solidPositions = {};
  VanishedWalls vanished = {};  ///< without walls unless some vanished in this step
};

WallContext wallContextOf(World& w, StepTools& t, double dt) {
  return {wallView(w),
          t.wallTables,
          t.liquids,
          dt,
          dt > 0 ? dt : nextStep(w.clock),
          1.0 / w.clock.substeps,
          w.modules.sleep ? &t.sleep.steady : nullptr};
}

/// Brings each particle to the rank of its cell; rebuilds bonds and links.
void redistributeAll(World& w, Halos halos, StepTools& t, double dt) {
  const bool leftSlots = redistribute(w, halos, t, dt);  // emit, remove, migrate, sort by (cell, id)
  if (w.modules.solid)
    rebuildSolidBonds(w, halos, t, {{}, t.phaseChangedHere || leftSlots || t.bondsAtStart});
  t.phaseChangedHere = false;
  if (w.modules.bodyTypes()) redistributeBodyTypes(w, halos, t, dt);
  if (w.modules.sheet) linkSheets(w.sheets, halos, t.times);
  if (w.modules.oriented) evaluateOriented(orientedView(w, t), halos, dt);
}

/// Finds neighbours and sums densities. Inner particles are summed while surrounding cells are exchanged.
void sumDensities(Evaluation& e) {
  World& w = e.w;
  StepTools& t = e.t;
  const Modules& m = w.modules;
  Exchange ghosts;
  if (e.neighbours) ghosts = sendGhosts(e.halos.cells, w.particles, w.cells, ghostColumns(w));
  if (m.solid) e.solidPositions = sendPositions(w, e.halos, t);
  t.times.lap(StepPhase::Exchange);
  clearRates(w.particles, m.uniform);
  if (e.neighbours) {
    if (m.continuity) beginCarry(carryContext(w, t, e.dt));
    markInner(w, e.halos.cells, t);
    if (m.sleep) markSleepingInner(sleepView(w, t));
    sumOverNeighbours(w, t, NeighbourPass::InnerDensity, e.dt);
    ghosts.wait();
    t.times.lap(StepPhase::Exchange);
    markInner(w, e.halos.cells, t);
    if (m.sleep) markSleeping(sleepView(w, t));
    sumOverNeighbours(w, t, NeighbourPass::BoundaryDensity, e.dt);
  }
  if (m.sleep) dropSkippedContacts(t.sleep, t.wallContacts);
  if (!e.vanished.walls.list.empty())
    recordVanished(e.walls, {t.surface, t.inverseLatticeSum}, e.vanished, t.wallContacts);
  if (m.fluid && !m.continuity) addWallRelativeDensity(e.walls, t.inverseLatticeSum, t.wallContacts);
  t.times.lap(StepPhase::Walls);
  if (m.continuity && e.neighbours) finishCarry(carryContext(w, t, e.dt));
  if (m.shifting && !m.continuity) shiftInside(carryContext(w, t, e.dt));
  if (m.contactConductance && e.neighbours)
    findContactNormals(pairSumsOf(w, t), w.particles.owned + t.ghostRoom, w.particles, t.contactHeat);
  if (m.evaporation && e.neighbours) {
    t.kernels->freeSurfaceIndicator(pairSumsOf(w, t), {0, w.neighbours.groups});
    findExposure(evaporationView(w, t));
  }
  if (m.surfaceEnergy) findSurfaceEnergy(e.walls, t.surface, t.wallContacts);
  if (m.flowLaw) findApparentViscosity(e.walls, t.wallContacts, pairSumsOf(w, t));
  if (m.tension || !t.pairForces.empty()) recordEnergyLeft(w, t);
}

/// Columns of ghosts that follow from densities, shear rates and normals.
ColumnList densityColumns(World& w) {
  Continuum& p = w.particles;
  ColumnList columns{};
  if (w.modules.fluid) columns.push_back(&p.relativeDensity);
  if (w.modules.contactConductance) columns.push_back(&p.contactNormal);
  if (w.modules.evaporation) columns.push_back(&p.exposure);
  if (p.correction.active) columns.push_back(&p.correction);
  if (p.relief.active) columns.push_back(&p.relief);
  if (p.apparentViscosity.active) columns.push_back(&p.apparentViscosity);
  if (w.modules.surfaceEnergy) {
    columns.push_back(&p.surfaceEnergyByGradient);
    columns.push_back(&p.surfaceEnergyByColour);
  }
  return columns;
}

/// Pressure, viscosity, heat and tension of pairs, and stress of solids, while densities are exchanged.
void sumForces(Evaluation& e) {
  World& w = e.w;
  StepTools& t = e.t;
  const Modules& m = w.modules;
  Exchange densities, stress;
  if (m.fluid || m.contactConductance) densities = refresh(e.halos.cells, w.particles, densityColumns(w));
  t.times.lap(StepPhase::Exchange);
  if (m.solid)  // F, stress; bonds break, form, take new references
    stress = deform(w, e.halos, t, e.dt, {std::move(e.solidPositions), densities});
  if (m.neighbours) sumOverNeighbours(w, t, NeighbourPass::InnerForces);
  densities.wait();
  t.times.lap(StepPhase::Exchange);
  if (m.neighbours) sumOverNeighbours(w, t, NeighbourPass::BoundaryForces);
  if (w.particles.softening.active && m.fluid)
    beginSoftening(w, t);  // derivative of pair and contact energies with respect to the liquid fraction
  if (!t.pairForces.empty()) sumPairForces(w, t);
  if (m.solid) addElasticForces(w, t, e.dt, std::move(stress));
  if (m.buoyancy) addBuoyancy(w.scene, w.particles);
}

/// Contact of solids, walls, sheets and oriented particles. justFrozen: records the jump of all contacts, as
/// an evaluation with new coefficients does.
void addContacts(Evaluation& e, bool justFrozen) {
  World& w = e.w;
  StepTools& t = e.t;
  const Modules& m = w.modules;
  if (m.contact)
    addSolidContacts(
        {w.scene, w.grid, w.solids, w.bonds, e.walls.span, justFrozen ? &w.ledger.phaseJump : nullptr,
         &t.contactResistance, m.fluid ? nullptr : &w.counters.coincidentPairs},
        t.closePairs, w.particles);
  t.times.lap(StepPhase::Contact);
  if (m.sleep) recordConstraintForces(w.particles, w.scene, t.sleep);
  addWallForces(e.walls, t.inverseLatticeSum, t.wallContacts);
  t.times.lap(StepPhase::Walls);
  if (m.sheet)
    loadSheets(sheetView(w), e.halos, t.times, e.dt);  // forces on vertices, and of vertices on particles
  if (m.orientedContact)
    addContinuumContact(orientedView(w, t), e.dt);  // oriented particles and the continuum
  if (m.oriented)
    recordBirthContacts(w.oriented.rows, t.oriented, w.ledger);  // contacts of particles born in this step
}

/// Adds forces that need all others, and heat from outside.
void finishForces(Evaluation& e) {
  World& w = e.w;
  StepTools& t = e.t;
  if (w.modules.contact) recordResistance(e.walls, t.contactResistance);
  recordClamps(e.walls, t.wallContacts);
  if (w.modules.implicitViscosity) solveViscosity(w, e.halos, t, e.walls);
  if (w.modules.heat) {
    addWallHeat(e.walls, t.wallContacts);
    addOuterHeat(heatView(w), e.dt, e.walls.steady);
    addThermostats(heatView(w), e.dt);
    if (w.modules.evaporation) findVapour(evaporationView(w, t), e.dt);
    if (w.modules.lamps) addHeatSources({heatView(w), w.walls, *t.light}, e.dt, e.halos.all);
  }
  if (w.modules.mushDrag) findMush(heatView(w), w.grid, w.neighbours);
  if (w.particles.outsideForce.active)
    addOutsideLoads(t.outside, w.particles, w.ledger, e.dt > 0 ? timeAfter(w.clock, e.dt) : w.clock.time,
                    e.dt);
}

}  // namespace

void evaluate(World& w, Halos halos, StepTools& t, double dt) {
  redistributeAll(w, halos, t, dt);
  t.hooks.after(HookPhase::Redistribute);
  Evaluation e{w, halos, t, dt, wallContextOf(w, t, dt)};
  // First, since it projects particles out of walls: ghosts and bonds must use the new positions.
  if (dt > 0 && someVanished(w.walls, w.clock.time)) findVanished(e.walls, w.clock.time, e.vanished);
  findWallContacts(e.walls, t.wallContacts);
  t.times.lap(StepPhase::Walls);
  if (w.modules.sleep) beginSleep(sleepView(w, t), dt);
  const std::int64_t coincident = w.counters.coincidentPairs;
  e.neighbours = needsNeighbours(w.modules, t);
  const bool justFrozen = t.frozeAnywhere && w.modules.freezing && dt > 0;
  sumDensities(e);
  if (w.modules.rigid && t.rigid.atStart) updatePieces(rigidView(w, t), halos, true);
  t.rigid.atStart = false;
  if (w.modules.rigid) linkPieces(rigidView(w, t), halos, PieceUsers::AndGhosts);
  t.times.lap(StepPhase::Contact);
  t.hooks.after(HookPhase::Density);
  sumForces(e);
  addContacts(e, justFrozen);
  finishForces(e);
  if (w.modules.rigidify) compareLoads(rigidifyView(w, t));
  if (w.modules.rigid) sumPieceForces(rigidView(w, t), halos.all);
  if (viscosityCorrectionDue(w)) correctViscosity(w, t);  // for the next step
  if (w.modules.neighbours) separateCoincident(w, t, coincident);
  t.times.lap(StepPhase::Heat);
  t.hooks.after(HookPhase::Forces);
}

}  // namespace thaw
