// SPDX-License-Identifier: Apache-2.0
#include "core/sleep/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/materials/enthalpy.hpp"
#include "core/neighbours/search.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/source_times.hpp"
#include "core/sleep/awake_reason.hpp"
#include "core/sleep/sleep_view.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/solid/laws/plasticity.hpp"

namespace thaw {
namespace {

enum : std::uint8_t { AtRest = 1, Settled = 2, Asleep = 4, Everything = 7 };

/// Returns the bits that all particles of a cell have in common.
std::uint8_t bitsOf(const Continuum& p, const CellTable& cells, std::size_t c, double after) {
  const std::size_t first = cells.first[c], count = cells.count[c];
  const float* const restTime = p.restTime.data() + first;
  const std::uint8_t* const sleep = p.sleep.data() + first;
  float shortest = std::numeric_limits<float>::infinity();
  std::uint8_t lightest = sleeping;
  for (std::size_t k = 0; k < count; k++) {
    shortest = restTime[k] < shortest ? restTime[k] : shortest;
    lightest = sleep[k] < lightest ? sleep[k] : lightest;
  }
  return static_cast<std::uint8_t>((static_cast<double>(shortest) >= after ? AtRest : 0) |
                                   (lightest >= sleepSettled ? Settled : 0) |
                                   (lightest == sleeping ? Asleep : 0));
}

/// Returns true if nothing in the sums of a cell changes. Stage 2 in the surrounding cells is not enough,
/// since bonds transmit stress from two cells away. Around a particle at stage 3, all particles are at
/// stage 2.
bool isSteady(std::uint8_t around) { return (around & (AtRest | Asleep)) == (AtRest | Asleep); }

/// Combines the bits of the 27 cells around each cell. Keys ascend, so nine indices advance through the
/// table.
void lookAround(const CellTable& cells, const std::vector<std::uint8_t>& own,
                std::vector<std::uint8_t>& around) {
  std::size_t at[9] = {};
  std::uint64_t low[9];  // first of three keys along x, relative to the cell's own key
  for (int k = 0; k < 9; k++)
    low[k] = static_cast<std::uint64_t>((k / 3 - 1) * (1ll << 42) + (k % 3 - 1) * (1ll << 21) - 1);
  const std::size_t n = cells.key.size();
  for (std::size_t c = 0; c < n; c++) {
    std::uint8_t bits = own[c];
    for (std::size_t k = 0; k < 9; k++) {
      const std::uint64_t from = cells.key[c] + low[k];
      while (at[k] < n && cells.key[at[k]] < from) at[k]++;
      for (std::size_t d = at[k]; d < n && cells.key[d] <= from + 2; d++) bits &= own[d];
    }
    around[c] = bits;
  }
}

/// Returns true if all bonds of the solid end within the 27 surrounding cells and its strain is small.
/// Otherwise the solid is evaluated in every step, which also counts inverted and weakened particles.
bool mayBeSkipped(const SleepView& w, std::uint32_t solidIndex) {
  const Solids& s = w.solids;
  for (int k = 0; k < w.bonds.capacity; k++) {
    if (!w.bonds.hasBond(solidIndex, k)) continue;
    Vec3d d = s.position[w.bonds.neighbour[w.bonds.at(solidIndex, k)]] - s.position[solidIndex];
    for (int a = 0; a < 3; a++) {
      if (w.grid.periodic[a]) d[a] -= w.grid.period[a] * std::nearbyint(d[a] / w.grid.period[a]);
      if (!(std::abs(d[a]) < w.grid.edge[a])) return false;
    }
  }
  constexpr double largest = 0.3;  // limit of |F^T F - 1|
  const Mat3d& f = s.deformation[solidIndex];
  double size2 = 0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      double c = a == b ? -1 : 0;
      for (int r = 0; r < 3; r++) c += f.row[r][a] * f.row[r][b];
      size2 += c * c;
    }
  return size2 < largest * largest && determinant(f) > 0 &&
         !(s.plasticInverse.active && norm(plasticMetric(s.plasticInverse[solidIndex])) > 0.5);
}

AwakeReason awakeReasonOf(const Continuum& p, const Scene& scene, std::size_t i, const Vec3d& acceleration) {
  const Numerics& n = scene.numerics;
  if (p.phase[i] != Solid || p.solidIndex[i] == noSolid || (p.liquid.active && p.liquid[i] > 0))
    return AwakeReason::NotSolid;
  // The limit is at most half of gravity. Otherwise, with a large sleep_speed, a freely falling particle
  // could count as at rest and stop in the air.
  const double slow = n.sleepSpeed, g = length(scene.domain.gravity),
               weak = std::min(slow / n.sleepAfter, g > 0 ? 0.5 * g : never);
  if (!(dot(p.velocity[i], p.velocity[i]) < slow * slow)) return AwakeReason::Moves;
  if (!(dot(acceleration, acceleration) < weak * weak)) return AwakeReason::Accelerates;
  if (!p.heatFlow.active ||
      std::abs(p.heatFlow[i]) <
          n.sleepHeating * p.mass[i] * heatCapacityOf(n.heat, scene.materials[p.material[i]], 0))
    return AwakeReason::None;
  return AwakeReason::Warms;
}

/// Force (N) that balances the particle's weight and the forces known so far.
Vec3d balancing(const Continuum& p, const Scene& scene, std::size_t i) {
  return -p.force[i] - scene.domain.gravity * p.mass[i];
}

void wakeAll(Continuum& p) { std::fill_n(p.restTime.data(), p.owned, 0.0f); }

}  // namespace

void beginSleep(const SleepView& w, double dt) {
  Continuum& p = w.particles;
  w.sleep.interaction.assign(p.interaction.data(), p.interaction.data() + p.owned);
  const double begin = w.clock.time, end = begin + dt;
  for (const Wall& wall : w.walls.list)
    if (wall.properties.until >= begin && wall.properties.until <= end) wakeAll(p);
  for (const Thermostat& heat : w.scene.thermostats)
    if (end > heat.start && begin <= heat.start + heat.over) wakeAll(p);
  if (anySourceOn(w.scene, begin, end)) wakeAll(p);
  for (const WallContact& c : w.wallContacts.list) {
    const Wall& wall = w.walls.list[c.wall];
    if (!wall.properties.motion.empty() && wallVelocity(wall, p.position[c.row]) != Vec3d{})
      p.restTime[c.row] = 0;
  }
}

namespace {

/// Computes SleepWork::cell and around for the present cells.
void lookAtCells(const SleepView& w) {
  SleepWork& s = w.sleep;
  const std::size_t n = w.cells.key.size();
  s.cell.resize(n);
  s.around.resize(n);
  for (std::size_t c = 0; c < n; c++)
    s.cell[c] = bitsOf(w.particles, w.cells, c, w.scene.numerics.sleepAfter);
  lookAround(w.cells, s.cell, s.around);
}

void markSteady(const SleepView& w, std::size_t c) {
  std::fill_n(w.sleep.steady.begin() + static_cast<std::ptrdiff_t>(w.cells.first[c]), w.cells.count[c],
              std::uint8_t{1});
}

}  // namespace

std::array<std::int64_t, awakeReasons> countAwake(const Continuum& p, const Scene& scene) {
  std::array<std::int64_t, awakeReasons> count{};
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.sleep[i] == awake)
      count[static_cast<std::size_t>(
          awakeReasonOf(p, scene, i, p.clamped.active && p.clamped[i] ? Vec3d{} : p.acceleration[i]))]++;
  return count;
}

void wakeEverything(Continuum& p) {
  wakeAll(p);
  std::fill_n(p.sleep.data(), p.owned, awake);
}

void markSleepingInner(const SleepView& w) {
  const Continuum& p = w.particles;
  SleepWork& s = w.sleep;
  lookAtCells(w);
  const std::size_t n = w.cells.key.size();
  bool any = false;
  s.steady.assign(p.owned, 0);
  for (std::size_t c = 0; c < n; c++)
    if (w.inner[c] == 1 && isSteady(s.around[c])) markSteady(w, c);
  s.known.assign(n, 0);
  for (std::size_t c = 0; c < n; c++) {
    if (s.recomputeAll || w.inner[c] != 1 || !isSteady(s.around[c])) continue;
    w.inner[c] = skippedCell;
    s.known[c] = 1;
    any = true;
  }
  s.seen.assign(any ? 0 : 1, RowSpan{0, static_cast<std::uint32_t>(p.owned)});
  if (!any) return;
  s.surroundedBySkipped.resize(n);
  lookAround(w.cells, s.known, s.surroundedBySkipped);
  for (std::size_t c = 0; c < n; c++)
    if (!s.surroundedBySkipped[c] && w.cells.first[c] < p.owned)
      addRows(s.seen, w.cells.first[c], w.cells.count[c]);
}

void markSleeping(const SleepView& w) {
  const Continuum& p = w.particles;
  SleepWork& s = w.sleep;
  const std::size_t n = w.cells.key.size();
  if (n != s.around.size()) lookAtCells(w);  // equal sizes: there are no ghosts
  s.steady.assign(p.owned, 0);
  s.skipped.assign(p.owned, 0);
  s.rows.clear();
  s.steadyCells.clear();
  for (std::size_t c = 0; c < n; c++) {
    const std::size_t first = w.cells.first[c], count = w.cells.count[c];
    if (first >= p.owned) continue;
    const bool steady = isSteady(s.around[c]), skip = steady && !s.recomputeAll;
    if (skip) w.inner[c] = skippedCell;
    else addRows(s.rows, first, count);
    if (!steady) continue;
    s.steadyCells.push_back(w.cells.key[c]);
    markSteady(w, c);
    std::fill_n(s.skipped.begin() + static_cast<std::ptrdiff_t>(first), count,
                static_cast<std::uint8_t>(skip));
  }
}

std::span<const RowSpan> awakeRows(const Modules& modules, const Continuum& p, SleepWork& sleep) {
  // Under the last two conditions, sleeping particles also move or are counted.
  const bool all = !modules.sleep || sleep.recomputeAll || p.shiftingVelocity.active ||
                   p.fastAcceleration.active;
  if (all) sleep.rows.assign(1, RowSpan{0, static_cast<std::uint32_t>(p.owned)});
  return sleep.rows;
}

std::span<const RowSpan> visibleRows(const Modules& modules, const Continuum& p, SleepWork& sleep) {
  if (!modules.sleep) sleep.seen.assign(1, RowSpan{0, static_cast<std::uint32_t>(p.owned)});
  return sleep.seen;
}

void dropSkippedContacts(const SleepWork& sleep, WallContacts& contacts) {
  std::erase_if(contacts.list, [&](const WallContact& c) { return sleep.skipped[c.row] != 0; });
}

void forgetChangedSolids(const Solids& solids, SleepWork& sleep) {
  sleep.fresh.resize(solids.owned, 0);
  for (std::size_t s = 0; s < solids.owned; s++)
    if (solids.changed[s]) sleep.fresh[s] = 0;
}

void chooseAwakeGroups(const Continuum& p, const Solids& solids, ElasticWork& e, SleepWork& s) {
  if (s.recomputeAll) s.fresh.assign(solids.owned, 0);
  s.fresh.resize(solids.owned, 0);
  e.plasticFixed.resize(solids.owned);
  for (std::size_t k = 0; k < solids.owned; k++) e.plasticFixed[k] = p.sleep[solids.particle[k]] != awake;
  e.groupStretch2.resize((solids.owned + lanes - 1) / lanes, 1);
  const auto choose = [&](const std::vector<std::uint32_t>& all, std::vector<std::uint32_t>& some) {
    some.clear();
    for (const std::uint32_t g : all) {
      const std::size_t first = static_cast<std::size_t>(g) * lanes,
                        last = std::min<std::size_t>(first + lanes, solids.owned);
      bool known = true;
      for (std::size_t k = first; k < last; k++) known = known && s.fresh[k] && s.steady[solids.particle[k]];
      if (known) continue;
      some.push_back(g);
      std::fill(s.fresh.begin() + static_cast<std::ptrdiff_t>(first),
                s.fresh.begin() + static_cast<std::ptrdiff_t>(last), std::uint8_t{1});
    }
  };
  choose(e.inner, e.innerAwake);
  choose(e.boundary, e.boundaryAwake);
  e.sleeping = true;
}

void recordConstraintForces(Continuum& p, const Scene& scene, const SleepWork& sleep) {
  for (std::size_t i = 0; i < p.owned; i++)
    // Unlike `skipped`, `steady` does not depend on the number of ranks.
    if (p.sleep[i] != awake && !sleep.steady[i]) p.constraintForce[i] = balancing(p, scene, i);
}

namespace {

/// Records the constraint force of steady rows. The sum is recomputed when the set of steady cells changes;
/// particles never enter or leave a steady cell.
void recordSteady(const Continuum& p, SleepWork& s, Ledger& ledger) {
  if (s.recomputeAll || s.steadyCells != s.steadyBefore) {
    s.steadyConstraintForce = {};
    for (std::size_t i = 0; i < p.owned; i++)
      for (int a = 0; s.steady[i] && a < 3; a++)
        s.steadyConstraintForce[static_cast<std::size_t>(a)].add(p.constraintForce[i][a]);
    s.steadyBefore = s.steadyCells;
  }
  for (int a = 0; a < 3; a++) ledger.wallForce[a] += s.steadyConstraintForce[static_cast<std::size_t>(a)];
}

/// Keeps the results of the last step for the steady rows of a cell.
void keepSteady(const SleepView& w, std::size_t first, std::size_t count) {
  Continuum& p = w.particles;
  std::copy_n(w.sleep.interaction.data() + first, count, p.interaction.data() + first);
  std::fill_n(p.dissipation.data() + first, count, 0.0);
  std::fill_n(w.neighbours.neighbours.data() + first, count,
              decltype(w.neighbours.neighbours)::value_type{0});
  w.counters.sleeping += static_cast<std::int64_t>(count);
  for (std::size_t i = first; p.clamped.active && i < first + count; i++) {
    if (!p.clamped[i]) continue;
    // The forces known so far may be complete or zero. The recorded force is exact in both cases.
    const Vec3d recorded = p.force[i] + w.scene.domain.gravity * p.mass[i];
    for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(recorded[a]);
  }
}

}  // namespace

void updateSleep(const SleepView& w, double dt) {
  Continuum& p = w.particles;
  SleepWork& s = w.sleep;
  const Vec3d g = w.scene.domain.gravity;
  const bool clamps = p.clamped.active;
  w.counters.sleeping = 0;
  recordSteady(p, s, w.ledger);
  for (std::size_t c = 0; c < w.cells.key.size(); c++) {
    const std::size_t first = w.cells.first[c], count = w.cells.count[c];
    if (first >= p.owned) continue;
    const std::uint8_t around = s.around[c];
    if (isSteady(around)) {
      keepSteady(w, first, count);
      continue;
    }
    for (std::size_t i = first; i < first + count; i++) {
      const bool fixed = clamps && p.clamped[i];
      const double m = p.mass[i];
      const Vec3d acceleration = fixed ? Vec3d{} : p.force[i] / m + g,
                  constraintForce = balancing(p, w.scene, i);
      const bool atRest = awakeReasonOf(p, w.scene, i, acceleration) == AwakeReason::None;
      p.restTime[i] = atRest ? static_cast<float>(static_cast<double>(p.restTime[i]) + dt) : 0.0f;
      if (!atRest || !(around & AtRest)) p.sleep[i] = awake;
      else if (p.sleep[i] == awake) p.sleep[i] = sleepFixed;
      else if (p.sleep[i] == sleepFixed) p.sleep[i] = sleepSettled;
      else p.sleep[i] = (around & Settled) && mayBeSkipped(w, p.solidIndex[i]) ? sleeping : sleepSettled;
      if (p.sleep[i] == awake) continue;
      if (p.sleep[i] == sleepFixed) {
        const Vec3d v = p.velocity[i];
        p.dissipated[i] += 0.5 * m * dot(v, v);
        for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(-m * v[a]);
        p.velocity[i] = {};
      }
      if (fixed) continue;  // recorded with the clamped particles
      for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(constraintForce[a]);
    }
  }
  s.recomputeAll = false;
}

}  // namespace thaw
