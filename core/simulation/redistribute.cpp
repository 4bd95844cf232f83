// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/redistribute.hpp"

#include <algorithm>
#include <utility>

#include "core/domain/sides.hpp"
#include "core/halo/bonded_rows.hpp"
#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/simulation/ledger/energy_left.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/simulation/views/views.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {
namespace {

/// Appends the particles of layers that leave in (before, after] whose cell this rank owns.
std::size_t emit(World& w, const CellHalo& halo, const ParticleSources& sources, double before,
                 double after) {
  Continuum& p = w.particles;
  const std::size_t had = p.owned;
  for (std::size_t e = 0; e < w.scene.emitters.size(); e++) {
    const Emitter& emitter = w.scene.emitters[e];
    const EmitterPlan& plan = sources.emitters[e];
    const Material& m = w.scene.materials[static_cast<std::size_t>(emitter.material)];
    const Vec3d direction = normalized(emitter.direction);
    const std::int64_t begin = sources.emitFirst ? 0 : layersUntil(emitter, plan, before),
                       end = layersUntil(emitter, plan, after);
    for (std::int64_t layer = begin; layer < end; layer++) {
      const double age = after - leavingTime(emitter, plan, layer);  // negative in the nozzle
      for (std::size_t k = 0; k < plan.layer.size(); k++) {
        const Vec3d velocity = plan.velocity.empty() ? direction * emitter.speed : plan.velocity[k];
        const Vec3d x = plan.velocity.empty() ? plan.layer[k] + direction * (emitter.speed * age)
                                              : plan.layer[k] + velocity * age;
        const double temperature = plan.temperature.empty() ? emitter.temperature : plan.temperature[k];
        const std::uint64_t cell = cellKey(cellOf(w.grid, x));
        if (!halo.owns(cell)) continue;
        const std::size_t i = p.owned;
        p.resize(i + 1, 0);
        const std::uint64_t source = w.scene.bodies.size() + e;
        p.id[i] = particleId(source, static_cast<std::uint64_t>(layer) * plan.layer.size() + k);
        p.clamped[i] = age < 0 ? driven : 0;
        p.position[i] = x;
        p.velocity[i] = velocity;
        p.mass[i] = plan.particleMass;
        p.material[i] = static_cast<std::uint16_t>(emitter.material);
        p.body[i] = static_cast<std::uint16_t>(source);
        if (p.enthalpy.active) p.enthalpy[i] = ledgerEnthalpy(w.scene.numerics.heat, m, temperature, 1);
        if (p.temperature.active) p.temperature[i] = temperature;
        p.cell[i] = p.nextCell[i] = cell;
        if (p.solidIndex.active) p.solidIndex[i] = noSolid;
        w.ledger.entered.potential.add(cohesionAtEntry(plan, layer, k));
        w.counters.emitted++;
      }
    }
  }
  startFields(p, had, p.owned);
  if (AddedColumn* newborn = newbornOf(p)) {
    std::fill(newborn->row(0), newborn->row(had), 0.0);
    std::fill(newborn->row(had), newborn->row(p.owned), 1.0);
  }
  setPhase(w.scene, w.modules, p, had, p.owned);
  return p.owned - had;
}

/// Computes cell keys, if needed, and finds leaving particles, in blocks that fit the cache.
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

/// Records the particles that leave the domain. Their velocities are those of the half step. Their kinetic
/// energy is that after the second half kick, as for the particles that stay.
void recordLeaving(World& w, const StepTools& t, double dt) {
  const Continuum& p = w.particles;
  findStoredEnergy(w, t, t.redistribution.leaving);
  addToBalance(w, t.redistribution.leaving, w.ledger.left);
  for (const std::uint32_t i : t.redistribution.leaving) {
    const Vec3d kick = p.acceleration[i] * (0.5 * dt);
    w.ledger.left.kinetic.add(p.mass[i] * (dot(p.velocity[i], kick) + 0.5 * dot(kick, kick)));
  }
}

/// Adds rows, ascending, to those that leave.
void addLeaving(std::span<const std::uint32_t> rows, Continuum& p, std::vector<std::uint32_t>& leaving) {
  if (rows.empty()) return;
  for (const std::uint32_t i : rows) p.nextCell[i] = noCell;
  std::vector<std::uint32_t> all;
  std::set_union(leaving.begin(), leaving.end(), rows.begin(), rows.end(), std::back_inserter(all));
  leaving = std::move(all);
}

/// Records mass, momentum and energy of emitted particles, the last owned rows, as entered.
void recordEmitted(World& w, PhaseChangeWork& phaseChange, std::size_t emitted) {
  const Continuum& p = w.particles;
  std::vector<std::uint32_t> fresh;
  for (std::size_t i = p.owned - emitted; i < p.owned; i++) {
    fresh.push_back(static_cast<std::uint32_t>(i));
    if (p.phase[i] == Solid) phaseChange.here = true;  // emitted as solid: needs a row in Solids
  }
  addToBalance(w, fresh, w.ledger.entered);
}

/// Adds evaporated particles to those that leave, records and counts them all. Returns true if one of them
/// has a solid. Collective.
bool takeLeaving(World& w, Halos& halos, StepTools& t, double dt) {
  Continuum& p = w.particles;
  const std::vector<std::uint32_t> vapour = w.modules.evaporation && dt > 0
                                                ? removeVapour(heatView(w), recordContext(w, t.liquids), dt)
                                                : std::vector<std::uint32_t>{};
  addLeaving(vapour, p, t.redistribution.leaving);
  recordLeaving(w, t, dt);
  if ((w.modules.tension || !t.terms.pairForces.empty()) &&
      (hasOpenSide(w.scene.domain) || w.modules.evaporation))
    t.redistribution.leavers = leaversOfAll(w, t, halos.all);
  bool leftSolids = false;
  for (std::uint32_t i : t.redistribution.leaving) {
    w.ledger.dissipated.add(p.dissipated[i]);
    if (std::binary_search(vapour.begin(), vapour.end(), i)) w.counters.evaporated++;
    else countLeaving(w.scene.domain, p.position[i], w.counters);
    t.rigid.changedHere = t.rigid.changedHere || isRigid(p, i);
    leftSolids = leftSolids || (p.solidIndex.active && p.solidIndex[i] != noSolid);
  }
  return leftSolids;
}

/// Migrates particles by their cells, and bonds with them. Returns the moves with the particles that leave
/// the domain. Collective.
Migration migrateParticles(World& w, Halos& halos, StepTools& t, bool moves) {
  Continuum& p = w.particles;
  const std::size_t before = p.owned;
  Migration m;
  if (moves) m = halos.cells.migrate(p, {p.nextCell.data(), p.owned});
  computeCellKeys(w.grid, p, before, p.owned);
  if (w.modules.solid && moves) halos.bonds.migrate(bondedRows(p), w.solids, w.bonds, m);
  if (w.modules.rigid)
    for (const std::uint32_t i : m.departed)
      if (p.piece[i] != notRigid) t.rigid.departed.push_back(p.piece[i]);
  t.times.lap(StepPhase::Migrate);
  if (!t.redistribution.leaving.empty()) {
    std::vector<std::uint32_t> gone;
    std::merge(m.departed.begin(), m.departed.end(), t.redistribution.leaving.begin(),
               t.redistribution.leaving.end(), std::back_inserter(gone));
    m.departed = std::move(gone);
  }
  if (w.modules.sleep)
    for (std::size_t i = before; i < p.owned; i++)
      t.sleep.recomputeAll = t.sleep.recomputeAll || p.sleep[i] == asleep;
  return m;
}

/// Returns the columns that the step recomputes before they are read.
ColumnList staleColumns(const Modules& modules, Continuum& particles, double dt) {
  ColumnList stale{};
  // Both contacts read the last acceleration.
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

bool redistribute(World& w, Halos halos, StepTools& t, double dt) {
  Continuum& p = w.particles;
  RedistributionWork& work = t.redistribution;
  if (p.ghosts > 0) p.resize(p.owned, 0);
  // The clock still shows the beginning of the step.
  if (w.modules.emitters) releaseDriven(w.scene, t.sources.emitters, w.clock.time + dt, p);
  const std::size_t emitted = w.modules.emitters
                                  ? emit(w, halos.cells, t.sources, w.clock.time, w.clock.time + dt)
                                  : 0;
  t.sources.emitFirst = false;
  recordEmitted(w, t.phaseChange, emitted);

  // Without neighbour sums particles may stay on their first rank, so that bonds, which follow their ends
  // across ranks, need not migrate.
  const bool ordered = needsOrder(w.modules, w.walls, t.solid),
             moves = ordered || work.newPartition || w.modules.emitters;
  const bool partitioned = std::exchange(work.newPartition, false);
  if (std::exchange(work.looseMemory, partitioned)) trimFreedMemory();
  const bool open = hasOpenSide(w.scene.domain) && (work.mayLeave || emitted > 0);
  work.mayLeave = true;
  findCells(w, work.leaving, moves, open);
  if (!moves && !work.leaving.empty()) findCells(w, work.leaving, true, open);
  const bool leftSolids = takeLeaving(w, halos, t, dt);
  Migration m = migrateParticles(w, halos, t, moves);
  m.arrivals += emitted;
  if (ordered) sortByCell(p, m, work.sort, w.cells, staleColumns(w.modules, w.particles, dt));
  else if (m.arrivals > 0 || !m.departed.empty()) closeGaps(p, m);
  if (partitioned) freeOldBuffers(p, w.neighbours, t.sums.records, work.sort);
  t.times.lap(StepPhase::Sort);
  return leftSolids;
}

}  // namespace thaw
