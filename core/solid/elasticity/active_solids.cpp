// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/active_solids.hpp"

#include <algorithm>
#include <vector>

#include "core/solid/elasticity/elastic_records.hpp"
#include "core/solid/elasticity/solid_state.hpp"

namespace thaw {
namespace {

/// Returns true if `is` is true for the other end of a bond of the solid.
template<class Is>
bool anyEnd(const ElasticWork& work, const Bonds& bonds, std::size_t solidIndex, const Is& is) {
  for (int k = 0; k < work.bondCount[solidIndex / lanes]; k++)
    if (bonds.hasBond(solidIndex, k) && is(bonds.neighbour[bonds.at(solidIndex, k)])) return true;
  return false;
}

/// Returns true if the solid and all ends of its bonds belong to one piece.
bool insidePiece(const ElasticWork& work, const Bonds& bonds, std::size_t solidIndex,
                 const SolidPieces& pieces) {
  const std::uint64_t piece = pieces.piece[solidIndex];
  return piece != 0 &&
         !anyEnd(work, bonds, solidIndex, [&](std::uint32_t end) { return pieces.piece[end] != piece; });
}

template<class Real> void clearEnd(BondEnd<Real>& end) {
  end.hourglass = 0;
  std::fill(std::begin(end.flux), std::end(end.flux), Real(0));
}

void clearSolid(Solids& solids, std::size_t solidIndex) {
  if (solids.end.active) clearEnd(solids.end[solidIndex]);
  else clearEnd(solids.endDouble[solidIndex]);
  solids.force[solidIndex] = {};
  if (!(determinant(solids.deformation[solidIndex]) > 0))  // F is unknown if the solid came from a file or
                                                           // another rank
    solids.deformation[solidIndex] = identity3<double>();
  // the axes may turn
  if (solids.lastGradient.active) solids.lastGradient[solidIndex] = -1.0 * identity3<double>();
  if (solids.drag.active) solids.drag[solidIndex] = 0;
  if (solids.dissipated.active) solids.dissipated[solidIndex] = 0;
}

void deformSolid(const ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t solidIndex) {
  solids.deformation[solidIndex] = identity3<double>() + solidGradient(work, solids, bonds, solidIndex);
}

}  // namespace

void chooseActiveSolids(ElasticWork& work, Solids& solids, const Bonds& bonds, const SolidPieces& pieces) {
  std::vector<std::uint8_t> wasPassive;
  if (work.sleeping) wasPassive.swap(work.plasticFixed);
  work.plasticFixed.assign(solids.owned, 0);
  work.sleeping = false;
  for (std::size_t s = 0; s < solids.owned; s++) {
    if (!insidePiece(work, bonds, s, pieces)) {
      // The last evaluation did not compute F, and a frame may be written before the next evaluation.
      if (s < wasPassive.size() && wasPassive[s] != 0) deformSolid(work, solids, bonds, s);
      continue;
    }
    work.plasticFixed[s] = 1;
    work.sleeping = true;
    clearSolid(solids, s);
  }
  if (!work.sleeping) return;
  packPositions(work, solids, 0, solids.owned);  // the sums also read the passive ends of bonds
  // Only the owner of a remote end can determine whether the end is passive, so all groups with remote ends
  // are active.
  const auto pulls = [&](std::uint32_t end) { return end >= solids.owned || !work.plasticFixed[end]; };
  const auto choose = [&](const std::vector<std::uint32_t>& all, std::vector<std::uint32_t>& active) {
    active.clear();
    for (const std::uint32_t g : all) {
      const std::size_t first = static_cast<std::size_t>(g) * lanes,
                        last = std::min<std::size_t>(first + lanes, solids.owned);
      bool needed = false;
      for (std::size_t s = first; s < last && !needed; s++)
        needed = !work.plasticFixed[s] || anyEnd(work, bonds, s, pulls);
      if (needed) active.push_back(g);
      else if (!work.stretched.empty()) work.stretched[g] = 0;
    }
  };
  choose(work.inner, work.innerAwake);
  choose(work.boundary, work.boundaryAwake);
}

bool anyActiveSolid(const ElasticWork& work, const Solids& solids) {
  for (std::size_t s = 0; s < solids.owned; s++)
    if (!isPassive(work, s)) return true;
  return false;
}

void deformPassive(const ElasticWork& work, Solids& solids, const Bonds& bonds) {
  for (std::size_t s = 0; s < solids.owned; s++)
    if (isPassive(work, s)) deformSolid(work, solids, bonds, s);
}

}  // namespace thaw
