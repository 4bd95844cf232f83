// SPDX-License-Identifier: Apache-2.0
// Updates the data that is computed from the reference vectors of bonds, by group of solids.
#include <algorithm>

#include "core/solid/bonds/bond_entries.hpp"
#include "core/solid/elasticity/elastic_records.hpp"
#include "core/solid/elasticity/solid_state.hpp"

namespace thaw {

namespace {

std::size_t groupsOf(const Solids& solids) { return (solids.owned + lanes - 1) / lanes; }

/// Makes room for all groups; data of existing solids is kept.
void resizeWork(ElasticWork& work, const Solids& solids, const Bonds& bonds) {
  const std::size_t groups = groupsOf(solids);
  work.bondCount.resize(groups, 0);
  work.singularLanes.resize(groups, 0);
  work.remoteGroup.resize(groups, 0);
  work.ownFrames.resize(groups, 0);
  work.stretched.resize(groups, 0);
  work.flows.resize(groups * lanes, 0);
  work.rank.resize(groups * lanes, 0);
  work.perTrace.resize(groups * lanes, 0.0);
  work.perWeight.resize(groups * lanes, 0.0);
  work.strainBound.resize(groups * lanes, 0.0);
  work.capacity = bonds.capacity;
}

/// Padding lanes of the last group get bonds of weight 0 to the group's first solid, so that vector loops may
/// read them.
void padLastGroup(ElasticWork& work, const Solids& solids, Bonds& bonds) {
  for (std::size_t s = solids.owned; s < groupsOf(solids) * lanes; s++) {
    work.rank[s] = 0;
    work.perTrace[s] = work.perWeight[s] = work.strainBound[s] = 0;
    work.singularLanes[s / lanes] = static_cast<std::uint8_t>(work.singularLanes[s / lanes] &
                                                              ~(1u << s % lanes));
    for (int k = 0; k < bonds.capacity; k++)
      clearBond(bonds, bonds.at(s, k), static_cast<std::uint32_t>(s / lanes * lanes));
  }
}

/// Returns true if a bond of the group has two references. Unused entries have none.
bool haveOwnFrames(const Bonds& b, std::size_t begin, std::size_t end) {
  if (!b.twoFrames) return false;
  bool own = false;
  const auto look = [&](const BondReals& there, const BondReals& back) {
    for (std::size_t at = begin; at < end; at++) own = own || back[at] != -there[at];
  };
  look(b.x, b.rx);
  look(b.y, b.ry);
  look(b.z, b.rz);
  return own;
}

/// Updates the group's number of bond entries, and its flags for remote ends and for bonds with two
/// references.
void updateGroup(ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t g) {
  std::size_t last = 0;
  bool remote = false;
  for (int k = 0; k < bonds.capacity; k++)
    for (std::size_t s = g * lanes, end = std::min(s + lanes, solids.owned); s < end; s++) {
      if (!bonds.hasBond(s, k)) continue;
      last = static_cast<std::size_t>(k) + 1;
      remote = remote || bonds.neighbour[bonds.at(s, k)] >= solids.owned;
    }
  work.bondCount[g] = static_cast<std::uint16_t>(last);
  work.remoteGroup[g] = remote;
  work.ownFrames[g] = haveOwnFrames(bonds, bonds.at(g * lanes, 0), bonds.at(g * lanes, 0) + last * lanes);
}

void sortGroups(ElasticWork& work) {
  work.inner.clear();
  work.boundary.clear();
  for (std::size_t g = 0; g < work.remoteGroup.size(); g++)
    (work.remoteGroup[g] ? work.boundary : work.inner).push_back(static_cast<std::uint32_t>(g));
}

}  // namespace

std::int64_t refreshReference(ElasticWork& work, Solids& solids, Bonds& bonds, bool all) {
  all = all || work.capacity != bonds.capacity;  // entries move when the capacity grows
  resizeWork(work, solids, bonds);
  padLastGroup(work, solids, bonds);
  for (std::size_t g = 0; g < groupsOf(solids); g++) {
    bool any = all, each = true;
    const std::size_t first = g * lanes, end = std::min(first + lanes, solids.owned);
    for (std::size_t s = first; s < end; s++)
      any = any || solids.changed[s], each = each && (all || solids.changed[s]);
    if (!any) continue;
    if (each && end == first + lanes && !bonds.vectors) {
      packReferences(work, solids, first, end);
      refreshGroup(work, solids, bonds, g);
    } else {
      for (std::size_t s = first; s < end; s++)
        if (all || solids.changed[s]) {
          packReferences(work, solids, s, s + 1);
          refreshSolid(work, solids, bonds, s);
        }
    }
    updateGroup(work, solids, bonds, g);
  }
  sortGroups(work);
  packReferences(work, solids, solids.owned, solids.size());  // packs all remote rows, since it is unknown
                                                              // which are new
  return countSingular(work, solids);
}

}  // namespace thaw
