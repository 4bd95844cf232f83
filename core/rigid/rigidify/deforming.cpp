// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigidify/deforming.hpp"

#include <algorithm>

#include "core/neighbours/rows_around.hpp"
#include "core/solid/elasticity/active_slots.hpp"

namespace thaw {
namespace {

/// Steps between comparisons of strain rates. A pressure wave passes less than a bond in this time.
constexpr std::int64_t rateEvery = 4;
/// Steps between searches for particles that may become rigid.
constexpr std::int64_t restEvery = 32;
/// Temperature (K) below the solidus from which a particle that is woken with others counts as softening, so
/// that a melting front wakes whole layers.
constexpr double soonMelts = 0.5;

bool isSoft(const Scene& scene, const Continuum& p, std::size_t i, double margin) {
  if (!p.liquid.active) return false;
  return p.liquid[i] > 0 || p.temperature[i] > scene.materials[p.material[i]].solidus - margin;
}

/// Returns true if a bond of the slot changes its length faster than `rate` (1/s) times the length.
bool stretches(const RigidifyView& v, std::size_t slot, double rate) {
  const Solids& s = v.solids;
  for (int k = 0; k < v.elastic.bondCount[slot / lanes]; k++) {
    if (!v.bonds.hasBond(slot, k)) continue;
    const std::uint32_t end = v.bonds.neighbour[v.bonds.at(slot, k)];
    const Vec3d d = minimumImage(s.position[end] - s.position[slot], v.elastic.periods);
    const double length2 = dot(d, d), growth = dot(d, s.velocity[end] - s.velocity[slot]);
    if (growth * growth > rate * rate * length2 * length2) return true;
  }
  return false;
}

/// Sets the rest time of particles that touch something, or may do so soon, to 0.
void wakeTouching(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  for (const WallContact& c : v.wallContacts.list) p.restTime[c.row] = 0;
  for (const ClosePair& pair : v.closePairs.list)
    if (p.piece[pair.own] == notRigid || p.piece[pair.own] != p.piece[pair.other]) {
      bool bonded = false;
      const std::uint32_t slot = p.slot[pair.own];
      if (slot == noSlot) continue;
      for (int k = 0; k < v.elastic.bondCount[slot / lanes] && !bonded; k++)
        bonded = v.bonds.hasBond(slot, k) &&
                 v.solids.id[v.bonds.neighbour[v.bonds.at(slot, k)]] == p.id[pair.other];
      if (!bonded) p.restTime[pair.own] = 0;
    }
}

void wakeStretching(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  for (std::size_t s = 0; s < v.solids.owned; s++) {
    if (isPassive(v.elastic, s)) continue;
    float& rest = p.restTime[v.solids.particle[s]];
    if (rest > 0 && stretches(v, s, v.rigid.scene.numerics.rigidify)) rest = 0;
  }
}

}  // namespace

bool isToBeRigid(const Scene& scene, const Continuum& p, std::size_t i) {
  if (p.phase[i] != Solid || p.slot[i] == noSlot || (p.clamped.active && p.clamped[i] != 0)) return false;
  return p.restTime[i] > 0 &&
         (p.piece[i] != notRigid || static_cast<double>(p.restTime[i]) >= scene.numerics.sleepAfter);
}

void restAtStart(const Scene& scene, Continuum& p) {
  std::fill_n(p.restTime.data(), p.owned, static_cast<float>(scene.numerics.sleepAfter));
}

void wakeSoftening(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    if (isSoft(v.rigid.scene, p, i, soonMelts)) p.restTime[i] = 0;
}

bool findDeforming(const RigidifyView& v, double dt) {
  const Scene& scene = v.rigid.scene;
  Continuum& p = v.rigid.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    p.restTime[i] = p.phase[i] != Solid || p.slot[i] == noSlot || isSoft(scene, p, i, 0)
                        ? 0.0f
                        : static_cast<float>(static_cast<double>(p.restTime[i]) + dt);
  wakeTouching(v);
  const std::int64_t step = v.clock.step + 1;
  if (step % rateEvery == 0) wakeStretching(v);
  bool wakes = false, rests = false;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool rigid = isToBeRigid(scene, p, i);
    wakes = wakes || (p.piece[i] != notRigid && !rigid);
    rests = rests || (p.piece[i] == notRigid && rigid);
  }
  return wakes || (rests && step % restEvery == 0);
}

namespace {

/// Smallest and largest piece in each cell; 0 is a piece, too.
struct PieceRange {
  std::uint64_t low = ~std::uint64_t{0}, high = 0;
};

std::vector<PieceRange> pieceRanges(const RigidView& v) {
  const Continuum& p = v.particles;
  std::vector<PieceRange> ranges(v.cells.key.size());
  for (std::size_t c = 0; c < ranges.size(); c++)
    for (std::size_t i = v.cells.first[c]; i < v.cells.first[c] + v.cells.count[c]; i++) {
      if (p.phase[i] != Solid) continue;
      ranges[c].low = std::min(ranges[c].low, p.piece[i]);
      ranges[c].high = std::max(ranges[c].high, p.piece[i]);
    }
  return ranges;
}

}  // namespace

bool nothingDeforms(const RigidifyView& v) {
  const RigidView& r = v.rigid;
  if (r.work.changedHere || anyActiveSlot(v.elastic, v.solids)) return false;
  const std::vector<PieceRange> own = pieceRanges(r);
  PieceRange here;
  for (const PieceRange& c : own) here = {std::min(here.low, c.low), std::max(here.high, c.high)};
  if (here.low >= here.high) return true;
  std::vector<RowSpan> rows;
  for (std::size_t c = 0; c < own.size(); c++) {
    if (r.cells.first[c] >= r.particles.owned) continue;
    PieceRange range = own[c];
    rowsAround(r.cells, r.cells.key[c], rows);
    for (const RowSpan& span : rows)
      for (std::uint32_t i = span.begin; i < span.end; i++) {
        if (r.particles.phase[i] != Solid) continue;
        range.low = std::min(range.low, r.particles.piece[i]);
        range.high = std::max(range.high, r.particles.piece[i]);
      }
    if (range.low < range.high) return false;
  }
  return true;
}

}  // namespace thaw
