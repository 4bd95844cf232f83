#include "core/sleep/sleep.hpp"

#include <algorithm>
#include <cmath>

#include "core/heat/enthalpy.hpp"
#include "core/solid/plasticity.hpp"
#include "core/step.hpp"

namespace thaw {
namespace {

enum : std::uint8_t { Calm = 1, Held = 2, Asleep = 4, Everything = 7 };

/// Bits that all of the cell's particles have.
std::uint8_t bitsOf(const Continuum& p, const CellTable& cells, std::size_t c, double after) {
  std::uint8_t bits = Everything;
  for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c] && bits != 0; i++) {
    std::uint8_t own = static_cast<double>(p.calm[i]) >= after ? Calm : 0;
    if (p.sleep[i] >= heldBefore) own |= Held;
    if (p.sleep[i] == asleep) own |= Asleep;
    bits &= own;
  }
  return bits;
}

/// The bits that the 27 cells around each have in common. Keys ascend, so nine places move along the table.
void lookAround(const CellTable& cells, const std::vector<std::uint8_t>& own, std::vector<std::uint8_t>& around) {
  std::size_t at[9] = {};
  std::uint64_t low[9];  // the first of three keys along x, from the cell's own
  for (int k = 0; k < 9; k++) low[k] = static_cast<std::uint64_t>((k / 3 - 1) * (1ll << 42) + (k % 3 - 1) * (1ll << 21) - 1);
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

/// Are all bonds of the slot so short that their other ends are in the 27 cells around, and is it little strained? What is inside out, or has weakened, is
/// counted in every step.
bool mayBeSkipped(const World& w, std::uint32_t slot) {
  const Solids& s = w.solids;
  for (int k = 0; k < w.bonds.capacity; k++) {
    if (!w.bonds.there(slot, k)) continue;
    Vec3d d = s.position[w.bonds.neighbour[w.bonds.at(slot, k)]] - s.position[slot];
    for (int a = 0; a < 3; a++) {
      if (w.grid.periodic[a]) d[a] -= w.grid.period[a] * std::nearbyint(d[a] / w.grid.period[a]);
      if (!(std::abs(d[a]) < w.grid.edge[a])) return false;
    }
  }
  constexpr double largest = 0.3;  // of |F^T F - 1|
  const Mat3d& f = s.deformation[slot];
  double size2 = 0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      double c = a == b ? -1 : 0;
      for (int r = 0; r < 3; r++) c += f.row[r][a] * f.row[r][b];
      size2 += c * c;
    }
  return size2 < largest * largest && determinant(f) > 0 && !(s.plasticStrain.active && norm(s.plasticStrain[slot]) > 0.5);
}

bool isCalm(const World& w, std::size_t i, const Vec3d& acceleration) {
  const Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  if (p.phase[i] != Solid || p.slot[i] == noSlot || (p.liquid.active && p.liquid[i] > 0)) return false;
  // less than half of gravity, or whoever falls freely would be calm with a large sleep_speed, and be held in the air
  const double slow = n.sleepSpeed, g = length(w.scene.domain.gravity), weak = std::min(slow / n.sleepAfter, g > 0 ? 0.5 * g : never);
  if (!(dot(p.velocity[i], p.velocity[i]) < slow * slow) || !(dot(acceleration, acceleration) < weak * weak)) return false;
  if (!p.heatFlow.active) return true;
  return std::abs(p.heatFlow[i]) < n.sleepHeating * p.mass[i] * heatCapacityOf(n.heat, w.scene.materials[p.material[i]], 0);
}

/// N, what balances the particle's weight and the forces known by now.
Vec3d balancing(const World& w, std::size_t i) { return -w.particles.force[i] - w.scene.domain.gravity * w.particles.mass[i]; }

void wakeAll(Continuum& p) { std::fill_n(p.calm.data(), p.owned, 0.0f); }

}  // namespace

void beginSleep(World& w, StepTools& t, double dt) {
  Continuum& p = w.particles;
  t.sleep.interaction.assign(p.interaction.data(), p.interaction.data() + p.owned);
  const double begin = w.clock.time, end = begin + dt;
  for (const Wall& wall : w.walls.list)
    if (wall.properties.until >= begin && wall.properties.until <= end) wakeAll(p);
  for (const Tempering& heat : w.scene.temperings)
    if (end > heat.start && begin <= heat.start + heat.over) wakeAll(p);
  for (const WallContact& c : t.wallContacts.list) {
    const Wall& wall = w.walls.list[c.wall];
    if (!wall.properties.motion.empty() && wallVelocity(wall, p.position[c.row]) != Vec3d{}) p.calm[c.row] = 0;
  }
}

void markAsleep(World& w, StepTools& t, bool ghosts) {
  const Continuum& p = w.particles;
  SleepWork& s = t.sleep;
  const std::size_t n = w.cells.key.size();
  s.cell.resize(n);
  s.around.resize(n);
  for (std::size_t c = 0; c < n; c++) s.cell[c] = bitsOf(p, w.cells, c, w.scene.numerics.sleepAfter);
  lookAround(w.cells, s.cell, s.around);
  s.deep.assign(p.owned, 0);
  s.skipped.assign(p.owned, 0);
  for (std::size_t c = 0; c < n; c++) {
    if (w.cells.first[c] >= p.owned) continue;
    // not only held around: bonds bring what is two cells away, in the stress of their other end, and around what is asleep all is held
    const bool deep = (s.around[c] & (Calm | Asleep)) == (Calm | Asleep), skip = deep && !s.findAll;
    if (skip && (ghosts || t.inner[c] == 1)) t.inner[c] = skippedCell;
    std::fill_n(s.deep.begin() + w.cells.first[c], w.cells.count[c], deep);
    std::fill_n(s.skipped.begin() + w.cells.first[c], w.cells.count[c], skip);
  }
}

void dropSkippedContacts(StepTools& t) {
  std::erase_if(t.wallContacts.list, [&](const WallContact& c) { return t.sleep.skipped[c.row] != 0; });
}

void forgetChangedSlots(const World& w, StepTools& t) {
  t.sleep.fresh.resize(w.solids.owned, 0);
  for (std::size_t s = 0; s < w.solids.owned; s++)
    if (w.solids.changed[s]) t.sleep.fresh[s] = 0;
}

void chooseAwakeGroups(World& w, StepTools& t) {
  SleepWork& s = t.sleep;
  ElasticWork& e = t.elastic;
  const Solids& solids = w.solids;
  if (s.findAll) s.fresh.assign(solids.owned, 0);
  s.fresh.resize(solids.owned, 0);
  e.held.resize(solids.owned);
  for (std::size_t k = 0; k < solids.owned; k++) e.held[k] = w.particles.sleep[solids.particle[k]] != awake;
  e.groupStretch2.resize((solids.owned + lanes - 1) / lanes, 1);
  const auto choose = [&](const std::vector<std::uint32_t>& all, std::vector<std::uint32_t>& some) {
    some.clear();
    for (const std::uint32_t g : all) {
      const std::size_t first = static_cast<std::size_t>(g) * lanes, last = std::min<std::size_t>(first + lanes, solids.owned);
      bool known = true;
      for (std::size_t k = first; k < last; k++) known = known && s.fresh[k] && s.deep[solids.particle[k]];
      if (known) continue;
      some.push_back(g);
      std::fill(s.fresh.begin() + static_cast<std::ptrdiff_t>(first), s.fresh.begin() + static_cast<std::ptrdiff_t>(last), std::uint8_t{1});
    }
  };
  choose(e.inner, e.innerAwake);
  choose(e.boundary, e.boundaryAwake);
  e.sleeping = true;
}

void noteHolds(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.sleep[i] != awake && !t.sleep.deep[i]) p.hold[i] = balancing(w, i);  // whether a rank looks again or not
}

void settleSleep(World& w, StepTools& t, double dt) {
  Continuum& p = w.particles;
  SleepWork& s = t.sleep;
  const Vec3d g = w.scene.domain.gravity;
  const bool clamps = p.clamped.active;
  w.counters.asleep = 0;
  for (std::size_t c = 0; c < w.cells.key.size(); c++) {
    if (w.cells.first[c] >= p.owned) continue;
    const std::uint8_t around = s.around[c];
    for (std::size_t i = w.cells.first[c]; i < w.cells.first[c] + w.cells.count[c]; i++) {
      const bool fixed = clamps && p.clamped[i];
      const double m = p.mass[i];
      Vec3d hold = p.hold[i];
      if (s.deep[i]) {
        p.interaction[i] = s.interaction[i];
        p.dissipation[i] = 0;
        w.neighbours.neighbours[i] = 0;
      } else {
        const Vec3d a = fixed ? Vec3d{} : p.force[i] / m + g;
        hold = balancing(w, i);
        const bool calm = isCalm(w, i, a);
        p.calm[i] = calm ? static_cast<float>(static_cast<double>(p.calm[i]) + dt) : 0.0f;
        if (!calm || !(around & Calm)) p.sleep[i] = awake;
        else if (p.sleep[i] == awake) p.sleep[i] = heldNow;
        else if (p.sleep[i] == heldNow) p.sleep[i] = heldBefore;
        else p.sleep[i] = (around & Held) && mayBeSkipped(w, p.slot[i]) ? asleep : heldBefore;
      }
      if (p.sleep[i] == awake) continue;
      w.counters.asleep += s.deep[i];
      if (p.sleep[i] == heldNow) {
        const Vec3d v = p.velocity[i];
        p.dissipated[i] += 0.5 * m * dot(v, v);
        for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(-m * v[a]);
        p.velocity[i] = {};
      }
      if (fixed && !s.deep[i]) continue;  // booked with what is clamped
      for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(hold[a]);
      if (!fixed) continue;
      const Vec3d booked = p.force[i] + g * m;  // by the forces that are known, which may be all or none: taken out to the last bit
      for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(booked[a]);
    }
  }
  s.findAll = false;
}

}  // namespace thaw
