// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigidify/rigidify.hpp"

#include <algorithm>

#include "core/halo/exchange.hpp"
#include "core/halo/spread_labels.hpp"
#include "core/rigid/connect.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/piece_sums.hpp"
#include "core/rigid/rigidify/deforming.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/solid/elasticity/active_solids.hpp"

namespace thaw {
namespace {

/// Joins bonded solids that shall both be rigid.
DisjointSets joinBonded(const RigidifyView& v, const SolidPieces& labels) {
  const Solids& s = v.solids;
  DisjointSets sets(s.size());
  for (std::uint32_t i = 0; i < s.owned; i++) {
    if (labels.piece[i] == notRigid) continue;
    for (int k = 0; k < v.elastic.bondCount[i / lanes]; k++) {
      if (!v.bonds.hasBond(i, k)) continue;
      const std::uint32_t j = v.bonds.neighbour[v.bonds.at(i, k)];
      if (labels.piece[j] != notRigid) sets.join(i, j);
    }
  }
  return sets;
}

/// Labels each piece by 1 + the smallest id of its bonded particles.
void labelBonded(const RigidifyView& v, const Halos& halos, SolidPieces& labels) {
  const Continuum& p = v.rigid.particles;
  Solids& s = v.solids;
  for (std::size_t i = 0; i < s.owned; i++) {
    const std::uint32_t row = s.particle[i];
    labels.piece[i] = isToBeRigid(v.rigid.scene, p, row) ? p.id[row] + 1 : notRigid;
  }
  refresh(halos.bonds, s, ColumnList{&labels.piece}).wait();
  DisjointSets sets = joinBonded(v, labels);
  spreadLabels({labels.piece.data(), s.size()}, s.owned, sets, halos.all,
               [&] { refresh(halos.bonds, s, ColumnList{&labels.piece}).wait(); });
}

/// Removes the labels of small pieces. Their particles become eligible again after sleep_after.
void dropSmall(const RigidifyView& v, Reducer& all, SolidPieces& labels) {
  const Solids& s = v.solids;
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < s.owned; i++)
    if (labels.piece[i] != notRigid) ids.push_back(labels.piece[i]);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto at = [&](std::uint64_t id) {
    return static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
  std::vector<std::int64_t> count(ids.size(), 0);
  for (std::size_t i = 0; i < s.owned; i++)
    if (labels.piece[i] != notRigid) count[at(labels.piece[i])]++;
  RankPieceExchange exchange(all, ids, nullptr);
  exchange.sum(count, 1);
  for (std::size_t i = 0; i < s.owned; i++) {
    if (labels.piece[i] == notRigid || count[at(labels.piece[i])] >= leastInPiece) continue;
    labels.piece[i] = notRigid;
    v.rigid.particles.restTime[s.particle[i]] = 0;
  }
}

}  // namespace

void rigidifySolids(const RigidifyView& v, const Halos& halos) {
  Continuum& p = v.rigid.particles;
  Solids& s = v.solids;
  SolidPieces labels;
  labels.resize(s.owned, s.ghosts);
  wakeSoftening(v);
  labelBonded(v, halos, labels);
  dropSmall(v, halos.all, labels);
  std::fill_n(p.setLabel.data(), p.owned, notRigid);
  for (std::size_t i = 0; i < s.owned; i++) p.setLabel[s.particle[i]] = labels.piece[i];
  remakePieces(v.rigid, halos, false);
  refresh(halos.bonds, s, ColumnList{&labels.piece}).wait();
  chooseActiveSolids(v.elastic, s, v.bonds, labels);
}

}  // namespace thaw
