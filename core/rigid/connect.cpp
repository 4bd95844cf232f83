// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/connect.hpp"

#include "core/halo/exchange.hpp"
#include "core/halo/spread_labels.hpp"
#include "core/neighbours/rows_around.hpp"

namespace thaw {

static_assert(noSet == notRigid);  // labels become ids of pieces

namespace {

bool connected(const RigidView& v, std::uint32_t i, std::uint32_t j, bool atStart,
               const SpecialPairs& special) {
  const Continuum& p = v.particles;
  const Vec3d d = p.position[j] - p.position[i];
  const double spacing = v.scene.spacing, distance2 = dot(d, d);
  const auto within = [&](double reach) { return distance2 < reach * spacing * (reach * spacing); };
  if (atStart) return p.body[i] == p.body[j] && within(connectedDistance);
  if (p.piece[i] == notRigid || p.piece[j] == notRigid) return within(joinDistance);
  if (p.piece[i] != p.piece[j]) return special.welded && special.welded(i, j);
  return within(connectedDistance);
}

/// Joins connected rows, including ghosts.
DisjointSets joinRows(const RigidView& v, bool atStart, const SpecialPairs& special) {
  Continuum& p = v.particles;
  DisjointSets sets(p.size());
  eachNear(v.cells, p.owned, v.cells, [&](std::uint32_t i, std::uint32_t j) {
    if (p.setLabel[i] == noSet || p.setLabel[j] == noSet || i == j) return;
    if (j < i && j < p.owned) return;  // the search from j handles this pair
    if (connected(v, i, j, atStart, special) && !(special.parted && special.parted(i, j))) sets.join(i, j);
  });
  return sets;
}

}  // namespace

void labelPieces(const RigidView& v, const Halos& halos, bool atStart, const SpecialPairs& special) {
  Continuum& p = v.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    p.setLabel[i] = belongsToPiece(v.scene, p, i) ? p.id[i] + 1 : noSet;
  refresh(halos.cells, p, ColumnList{&p.setLabel, &p.piece}).wait();
  DisjointSets sets = joinRows(v, atStart, special);
  spreadLabels({p.setLabel.data(), p.size()}, p.owned, sets, halos.all,
               [&] { refresh(halos.cells, p, ColumnList{&p.setLabel}).wait(); });
}

}  // namespace thaw
