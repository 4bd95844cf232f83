// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/active_slots.hpp"

#include <algorithm>
#include <vector>

#include "core/solid/elasticity/elastic_records.hpp"
#include "core/solid/elasticity/slot_state.hpp"

namespace thaw {
namespace {

/// Returns true if some bond of the slot has an end for which `is` holds.
template<class Is> bool anyEnd(const ElasticWork& work, const Bonds& bonds, std::size_t slot, const Is& is) {
  for (int k = 0; k < work.bondCount[slot / lanes]; k++)
    if (bonds.hasBond(slot, k) && is(bonds.neighbour[bonds.at(slot, k)])) return true;
  return false;
}

/// Returns true if the slot and all ends of its bonds belong to one piece.
bool insidePiece(const ElasticWork& work, const Bonds& bonds, std::size_t slot, const SlotPieces& pieces) {
  const std::uint64_t piece = pieces.piece[slot];
  return piece != 0 &&
         !anyEnd(work, bonds, slot, [&](std::uint32_t end) { return pieces.piece[end] != piece; });
}

template<class Real> void clearEnd(BondEnd<Real>& end) {
  end.hourglass = 0;
  std::fill(std::begin(end.flux), std::end(end.flux), Real(0));
}

void clearSlot(Solids& solids, std::size_t slot) {
  if (solids.end.active) clearEnd(solids.end[slot]);
  else clearEnd(solids.endDouble[slot]);
  solids.force[slot] = {};
  if (!(determinant(solids.deformation[slot]) > 0))  // unknown: the slot came from a file or another rank
    solids.deformation[slot] = identity3<double>();
  if (solids.lastGradient.active) solids.lastGradient[slot] = -1.0 * identity3<double>();  // it may turn
  if (solids.drag.active) solids.drag[slot] = 0;
  if (solids.dissipated.active) solids.dissipated[slot] = 0;
}

void deformSlot(const ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t slot) {
  solids.deformation[slot] = identity3<double>() + slotGradient(work, solids, bonds, slot);
}

}  // namespace

void chooseActiveSlots(ElasticWork& work, Solids& solids, const Bonds& bonds, const SlotPieces& pieces) {
  std::vector<std::uint8_t> wasPassive;
  if (work.sleeping) wasPassive.swap(work.held);
  work.held.assign(solids.owned, 0);
  work.sleeping = false;
  for (std::size_t s = 0; s < solids.owned; s++) {
    if (!insidePiece(work, bonds, s, pieces)) {
      // The last evaluation left out F, and a frame may be written before the next one.
      if (s < wasPassive.size() && wasPassive[s] != 0) deformSlot(work, solids, bonds, s);
      continue;
    }
    work.held[s] = 1;
    work.sleeping = true;
    clearSlot(solids, s);
  }
  if (!work.sleeping) return;
  packPositions(work, solids, 0, solids.owned);  // the sums also read the passive ends of bonds
  // The owner of a remote end decides whether it is passive, so all groups with remote ends are active.
  const auto pulls = [&](std::uint32_t end) { return end >= solids.owned || !work.held[end]; };
  const auto choose = [&](const std::vector<std::uint32_t>& all, std::vector<std::uint32_t>& active) {
    active.clear();
    for (const std::uint32_t g : all) {
      const std::size_t first = static_cast<std::size_t>(g) * lanes,
                        last = std::min<std::size_t>(first + lanes, solids.owned);
      bool needed = false;
      for (std::size_t s = first; s < last && !needed; s++)
        needed = !work.held[s] || anyEnd(work, bonds, s, pulls);
      if (needed) active.push_back(g);
      else if (!work.stretched.empty()) work.stretched[g] = 0;
    }
  };
  choose(work.inner, work.innerAwake);
  choose(work.boundary, work.boundaryAwake);
}

bool anyActiveSlot(const ElasticWork& work, const Solids& solids) {
  for (std::size_t s = 0; s < solids.owned; s++)
    if (!isPassive(work, s)) return true;
  return false;
}

void deformPassive(const ElasticWork& work, Solids& solids, const Bonds& bonds) {
  for (std::size_t s = 0; s < solids.owned; s++)
    if (isPassive(work, s)) deformSlot(work, solids, bonds, s);
}

}  // namespace thaw
