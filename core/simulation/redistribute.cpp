// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/redistribute.hpp"

#include <algorithm>
#include <utility>

#include "core/domain/sides.hpp"
#include "core/simulation/ledger/energy_left.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

/// Computes cell keys, if needed, and finds leaving particles. It works in blocks that fit into the cache.
void findCells(World& w, std::vector<std::uint32_t>& leaving, bool keys, bool open) {
  constexpr std::size_t block = 1024;
  Continuum& p = w.particles;
  leaving.clear();
  if (!keys && !open) return;
  for (std::size_t begin = 0; begin < p.owned; begin += block) {
    const std::size_t end = std::min(p.owned, begin + block);
    if (keys) computeCellKeys(w.grid, p, begin, end);
    if (open) findLeaving(w.scene.domain, p, begin, end, leaving);
  }
}

/// Records the particles that leave the domain. Their velocities are those of the half step. The recorded
/// kinetic energy is that after the second half kick, as for the particles that stay.
void recordLeaving(World& w, const StepTools& t, double dt) {
  const Continuum& p = w.particles;
  findStoredEnergy(w, t, t.redistribution.leaving);
  addToBalance(w, t.redistribution.leaving, w.ledger.left);
  for (const std::uint32_t i : t.redistribution.leaving) {
    const Vec3d kick = p.acceleration[i] * (0.5 * dt);
    w.ledger.left.kinetic.add(p.mass[i] * (dot(p.velocity[i], kick) + 0.5 * dot(kick, kick)));
  }
}

/// Records and counts the particles that leave. Returns true if one of them has bonds. Collective.
bool takeLeaving(StepContext& c) {
  World& w = c.w;
  StepTools& t = c.t;
  RedistributionWork& work = t.redistribution;
  recordLeaving(w, t, c.dt);
  if ((w.modules.tension || !t.terms.pairForces.empty()) &&
      (hasOpenSide(w.scene.domain) || w.modules.evaporation))
    work.leavers = leaversOfAll(w, t, c.halos.all);
  bool leftBonds = false;
  for (std::uint32_t i : work.leaving) {
    w.ledger.dissipated.add(w.particles.dissipated[i]);
    if (std::binary_search(work.vapour.begin(), work.vapour.end(), i)) w.counters.evaporated++;
    else countLeaving(w.scene.domain, w.particles.position[i], w.counters);
    t.rigid.changedHere = t.rigid.changedHere || isRigid(w.particles, i);
    leftBonds = leftBonds || (w.particles.solidIndex.active && w.particles.solidIndex[i] != noSolid);
  }
  return leftBonds;
}

/// Migrates particles by their cells. Particles that leave the domain are listed as departed. Collective.
void migrateParticles(StepContext& c) {
  Continuum& p = c.w.particles;
  RedistributionWork& work = c.t.redistribution;
  const std::size_t before = p.owned;
  work.migration = {};
  if (work.moved) work.migration = c.halos.cells.migrate(p, {p.nextCell.data(), p.owned});
  computeCellKeys(c.w.grid, p, before, p.owned);
  runPhase(ModulePhase::Migrated, c);  // bonds follow their particles; pieces, sleep
  c.t.times.lap(StepPhase::Migrate);
  if (work.leaving.empty()) return;
  std::vector<std::uint32_t> gone;
  std::merge(work.migration.departed.begin(), work.migration.departed.end(), work.leaving.begin(),
             work.leaving.end(), std::back_inserter(gone));
  work.migration.departed = std::move(gone);
}

/// Returns the columns that the step recomputes before they are read.
ColumnList staleColumns(const Modules& modules, Continuum& particles, double dt) {
  ColumnList stale{};
  // Contacts with sheets and with oriented particles read the last acceleration.
  if (dt > 0 && !modules.sheet && !modules.orientedContact) stale.push_back(&particles.acceleration);
  if (!modules.sleep) stale.push_back(&particles.interaction);
  return stale;
}

/// Frees buffers sized for the old partition.
void freeOldBuffers(Continuum& particles, NeighbourLists& neighbours, PairRecords& records,
                    SortBuffers& sort) {
  particles.shrink(1.0 / 64);
  neighbours = {};
  records = {};
  sort = {};
}

}  // namespace

bool needsOrder(const Modules& modules, const Walls& walls, const SolidWork& solid) {
  return needsNeighbours(modules, solid) || !walls.list.empty() || modules.bodyTypes() || modules.surface;
}

void redistribute(StepContext& c) {
  World& w = c.w;
  Continuum& p = w.particles;
  RedistributionWork& work = c.t.redistribution;
  if (p.ghosts > 0) p.resize(p.owned, 0);
  work.emitted = 0;
  runPhase(ModulePhase::Emission, c);  // layers of emitters

  // Without neighbour sums, particles may stay on their first rank. Bonds, which follow their ends across
  // ranks, then need not migrate.
  const bool ordered = needsOrder(w.modules, w.walls, c.t.solid);
  work.moved = ordered || work.newPartition || w.modules.emitters;
  const bool partitioned = std::exchange(work.newPartition, false);
  if (std::exchange(work.looseMemory, partitioned)) trimFreedMemory();
  const bool open = hasOpenSide(w.scene.domain) && (work.mayLeave || work.emitted > 0);
  work.mayLeave = true;
  findCells(w, work.leaving, work.moved, open);
  if (!work.moved && !work.leaving.empty()) findCells(w, work.leaving, true, open);
  runPhase(ModulePhase::Leaving, c);  // evaporated particles
  c.leftBonds = takeLeaving(c);
  migrateParticles(c);
  Migration& m = work.migration;
  m.arrivals += work.emitted;
  if (ordered) sortByCell(p, m, work.sort, w.cells, staleColumns(w.modules, p, c.dt));
  else if (m.arrivals > 0 || !m.departed.empty()) closeGaps(p, m);
  if (partitioned) freeOldBuffers(p, w.neighbours, c.t.sums.records, work.sort);
  c.t.times.lap(StepPhase::Sort);
}

}  // namespace thaw
