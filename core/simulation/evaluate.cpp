// SPDX-License-Identifier: Apache-2.0
// An evaluation of all forces.
#include <span>

#include "core/simulation/redistribute.hpp"
#include "core/simulation/step.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/coincident.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/walls/wall_offsets.hpp"

namespace thaw {
namespace {

/// Migrates particles to the ranks of their cells, then bonds, sheets and oriented particles.
void redistributeAll(StepContext& c) {
  redistribute(c);  // emit, remove, migrate, sort by (cell, id)
  // rebuilds bonds, migrates and links sheets and oriented particles, finds vanished obstacles
  runPhase(ModulePhase::Redistributed, c);
  c.t.phaseChange.here = false;
}

/// Finds the neighbours of inner rows, or of boundary rows, and sums their densities.
void sumDensities(StepContext& c, Part part, ModulePhase before) {
  markInner(c.w.cells, c.w.particles.owned, c.halos.cells, c.t.sums.inner);
  runPhase(before, c);  // skips sleeping rows
  searchNeighbours(c.w, c.t, part, c.dt);
  c.rows = passRows(part, c.w.neighbours, c.w.particles.owned, c.w.particles.size());
  runPhase(ModulePhase::DensitySums, c);  // density, carried density, colours of surface tension
  c.t.times.lap(StepPhase::Density);
}

/// Finds neighbours and sums densities. Sums of inner particles are computed while surrounding cells are
/// exchanged.
void findDensities(StepContext& c) {
  World& w = c.w;
  StepTools& t = c.t;
  const bool search = needsNeighbours(w.modules, t.solid);
  Exchange ghosts;
  if (search) ghosts = sendGhosts(c.halos.cells, w.particles, w.cells, t.phases.ghosts.withPositions);
  runPhase(ModulePhase::GhostsSent, c);  // positions of bonded rows of other ranks
  t.times.lap(StepPhase::Exchange);
  clearRates(w.particles, w.modules.uniform);
  if (search) {
    runPhase(ModulePhase::BeforeDensity, c);  // rates of the carried density
    sumDensities(c, Part::Inner, ModulePhase::InnerRows);
    ghosts.wait();
    t.times.lap(StepPhase::Exchange);
    sumDensities(c, Part::Boundary, ModulePhase::BoundaryRows);
  }
  // density near walls, shifting, viscosity of flow laws, tension at walls, contacts of bodies, volume
  // gradients
  runPhase(ModulePhase::Density, c);
  t.times.lap(StepPhase::Contact);
}

/// Sums pressure, viscosity, heat and tension of pairs.
void sumForces(StepContext& c, Part part) {
  if (!c.w.modules.neighbours) return;  // a scene of one solid searches only to form its bonds
  c.rows = passRows(part, c.w.neighbours, c.w.particles.owned, c.w.particles.size());
  runPhase(ModulePhase::ForceSums, c);  // pressure, viscosity, tension, conduction, close pairs of solids
  c.t.times.lap(StepPhase::Forces);
}

/// Computes pair forces and the stress of solids. The strain of solids is computed while densities are
/// exchanged.
void findForces(StepContext& c) {
  World& w = c.w;
  StepTools& t = c.t;
  const ColumnList& columns = t.phases.ghosts.withDensities;
  Exchange densities;
  if (!columns.empty()) densities = refresh(c.halos.cells, w.particles, columns);
  t.times.lap(StepPhase::Exchange);
  runPhase(ModulePhase::Deformation, c);  // strain and plastic flow of solids
  if (c.bondsForm) {
    densities.wait();                    // the formation of bonds sends further ghost columns
    runPhase(ModulePhase::NewBonds, c);  // freezing, welding
  }
  runPhase(ModulePhase::Stress, c);  // fracture, new references, exchange of stress
  sumForces(c, Part::Inner);
  densities.wait();
  t.times.lap(StepPhase::Exchange);
  sumForces(c, Part::Boundary);
  // elastic forces, tension by curvature, forces of scenes and extensions
  runPhase(ModulePhase::ContinuumForce, c);
}

/// Adds contacts of solids, walls, sheets and oriented particles.
void addContacts(StepContext& c) {
  runPhase(ModulePhase::Contact, c);  // contact of solids, constraint forces of sleeping solids
  c.t.times.lap(StepPhase::Contact);
  if (c.w.particles.wallOffset.active) findWallOffsets(c.walls.world, c.t.walls.contacts, c.w.bonds);
  addWallForces(c.walls, c.t.sums.scales.inverseLatticeSum, c.t.walls.contacts);
  c.t.times.lap(StepPhase::Walls);
  runPhase(ModulePhase::Coupling, c);  // sheets, oriented particles
  recordClamps(c.walls, c.t.walls.contacts);
}

}  // namespace

void evaluate(StepContext& c) {
  StepTools& t = c.t;
  redistributeAll(c);
  t.hooks.after(HookPhase::Redistribute);
  // This comes first, since it projects particles out of walls, and ghosts and bonds must use the new
  // positions.
  findWallContacts(c.walls, t.walls.contacts);
  t.times.lap(StepPhase::Walls);
  runPhase(ModulePhase::WallContacts, c);  // frozen particles, stages of sleep
  const std::int64_t coincident = c.w.counters.coincidentPairs;
  findDensities(c);
  t.hooks.after(HookPhase::Density);
  findForces(c);
  recordProjections(c.walls, t.walls.contacts);
  addContacts(c);
  // heat of walls, surroundings and sources; evaporation, mush, implicit viscosity, thermostats
  runPhase(ModulePhase::AllForces, c);
  if (c.w.modules.neighbours) separateCoincident(c.w, t.sums.records, coincident);
  t.times.lap(StepPhase::Heat);
  t.hooks.after(HookPhase::Forces);
}

void evaluate(World& w, Halos halos, StepTools& t, double dt) {
  StepContext c = stepContext(w, halos, t, dt);
  evaluate(c);
}

}  // namespace thaw
