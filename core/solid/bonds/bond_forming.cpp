// SPDX-License-Identifier: Apache-2.0
#include "core/solid/bonds/bond_forming.hpp"

#include <algorithm>

namespace thaw {

namespace {

bool mayWeld(const Continuum& p, const BondForming& f, std::size_t i, std::size_t j) {
  const Material &a = (*f.materials)[p.material[i]], &b = (*f.materials)[p.material[j]];
  if (!a.weld || !b.weld) return false;
  return p.body[i] != p.body[j] || (f.selfWeld && !(a.breakStretch < never) && !(b.breakStretch < never));
}

bool wanted(const Continuum& p, const BondForming& f, std::size_t i, std::size_t j) {
  const bool sameBody = p.body[i] == p.body[j];
  if (f.rule == BondRule::Start) return sameBody;
  const bool weld = (*f.materials)[p.material[i]].weld && (*f.materials)[p.material[j]].weld;
  if (p.justFrozen[i] || p.justFrozen[j]) return sameBody || weld;
  return f.rule == BondRule::Welding && mayWeld(p, f, i, j);
}

/// Returns true if particles i and j touch. x: distance vector, m.
bool touches(const Continuum& p, const BondForming& f, std::size_t i, std::size_t j, const Vec3d& x) {
  const double reach = p.body[i] == p.body[j] ? f.touch : f.touchBodies;
  return dot(x, x) < reach * reach;
}

bool bonded(const Solids& solids, const Bonds& bonds, std::size_t solidIndex, std::uint64_t id) {
  for (int k = 0; k < bonds.capacity; k++) {
    if (bonds.hasBond(solidIndex, k) && solids.id[bonds.neighbour[bonds.at(solidIndex, k)]] == id)
      return true;
  }
  return false;
}

}  // namespace

void prepareBondForming(Continuum& particles, const Solids& solids) {
  for (std::size_t i = 0; i < particles.owned; i++) {
    if (particles.unwrappedPosition.active) particles.unwrappedPosition[i] = particles.position[i];
    if (!particles.frame.active) continue;
    const bool old = particles.solidIndex[i] != noSolid && !particles.justFrozen[i];
    particles.frame[i] = old ? solids.deformation[particles.solidIndex[i]] : identity3<double>();
  }
}

ColumnList bondFormingColumns(Continuum& particles) {
  ColumnList columns{&particles.id, &particles.material, &particles.body, &particles.phase};
  if (particles.frame.active) {
    columns.push_back(&particles.frame);
    columns.push_back(&particles.justFrozen);
  }
  if (particles.unwrappedPosition.active) columns.push_back(&particles.unwrappedPosition);
  return columns;
}

Vec3d referenceIn(const Mat3d& frame, const Vec3d& x) {
  return determinant(frame) < 0.05 ? x : inverse(frame) * x;
}

bool touchesToWeld(const BondSearch& tables, const BondForming& f) {
  const auto& [p, solids, bonds, lists] = tables;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < lanes; l++) {
      const std::size_t i = lists.self[g * lanes + l];
      if (i >= p.owned || p.phase[i] != Solid || p.solidIndex[i] == noSolid ||
          !(*f.materials)[p.material[i]].weld)
        continue;
      for (std::uint32_t n = 0; n < lists.count[g]; n++) {
        const std::size_t j = lists.row(g, n, l);
        if (j == lists.dummy || p.phase[j] != Solid || p.id[j] == p.id[i] || !mayWeld(p, f, i, j)) continue;
        const Vec3d x = p.position[j] - p.position[i];
        if (touches(p, f, i, j, x) && !bonded(solids, bonds, p.solidIndex[i], p.id[j])) return true;
      }
    }
  return false;
}

std::int64_t formBonds(const BondSearch& tables, const BondForming& forming,
                       std::vector<BondRequest>& requests, ListedGroups range) {
  const auto& [p, solids, bonds, lists] = tables;
  // Shifted positions of periodic images are rounded, so only unshifted positions give both ends the same
  // bits.
  const Column<Vec3d>& place = p.unwrappedPosition.active ? p.unwrappedPosition : p.position;
  const bool frames = forming.rule != BondRule::Start;
  std::int64_t welds = 0;
  for (std::size_t g = range.first; g < std::min(range.last, lists.groups); g++)
    for (std::size_t l = 0; l < lanes; l++) {
      const std::size_t i = lists.self[g * lanes + l];
      if (i >= p.owned || p.phase[i] != Solid || p.solidIndex[i] == noSolid) continue;
      for (std::uint32_t n = 0; n < lists.count[g]; n++) {
        const std::size_t j = lists.row(g, n, l);
        if (j == lists.dummy || p.phase[j] != Solid || p.id[j] == p.id[i] || !wanted(p, forming, i, j))
          continue;
        const Vec3d x = minimumImage(place[j] - place[i], forming.periods);
        const double weight = bondWeight(x, forming.support);
        const bool old = frames && !p.justFrozen[i] && !p.justFrozen[j];
        if (!(weight > 0) || (old && !touches(p, forming, i, j, x))) continue;
        if (old && bonded(solids, bonds, p.solidIndex[i], p.id[j])) continue;
        requests.push_back({p.solidIndex[i], p.id[j], frames ? referenceIn(p.frame[i], x) : x,
                            frames ? referenceIn(p.frame[j], -x) : -x, weight,
                            j < p.owned ? p.solidIndex[j] : noSolid});
        welds += p.body[i] != p.body[j] && p.id[i] < p.id[j];
      }
    }
  return welds;
}

void pairAtStart(const Continuum& p, const NeighbourLists& lists, const BondForming& forming,
                 std::vector<BondPair>& pairs, ListedGroups range) {
  const Vec3d* const place = p.unwrappedPosition.active ? p.unwrappedPosition.data()
                                                        : p.position.data();  // as in formBonds
  for (std::size_t g = range.first; g < std::min(range.last, lists.groups); g++)
    for (std::size_t l = 0; l < lanes; l++) {
      const std::size_t i = lists.self[g * lanes + l];
      if (i >= p.owned || p.phase[i] != Solid || p.solidIndex[i] == noSolid) continue;
      const Vec3d at = place[i];
      const std::uint64_t id = p.id[i];
      const std::uint32_t solidIndex = p.solidIndex[i], body = p.body[i];
      for (std::size_t n = 0; n < lists.count[g]; n++) {
        const std::size_t j = lists.row(g, n, l);
        if (j == lists.dummy || p.phase[j] != Solid || p.body[j] != body || p.id[j] == id) continue;
        if (bondWeight(minimumImage(place[j] - at, forming.periods), forming.support) > 0)
          pairs.push_back({p.id[j], solidIndex, j < p.owned ? p.solidIndex[j] : noSolid});
      }
    }
}

}  // namespace thaw
