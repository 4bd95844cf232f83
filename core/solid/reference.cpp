// What the elastic step keeps of the bonds.
#include <algorithm>

#include "core/solid/slot_state.hpp"

namespace thaw {

namespace {

std::size_t groupsOf(const Solids& solids) { return (solids.owned + lanes - 1) / lanes; }

/// Room for all groups; what is there of slots that stay is kept.
void resizeWork(ElasticWork& work, const Solids& solids, const Bonds& bonds) {
  const std::size_t groups = groupsOf(solids), room = groups * static_cast<std::size_t>(bonds.capacity) * lanes;
  work.bondCount.resize(groups, 0);
  work.singularLanes.resize(groups, 0);
  work.remoteGroup.resize(groups, 0);
  work.stretched.resize(groups, 0);
  work.rank.resize(groups * lanes, 0);
  work.perTrace.resize(groups * lanes, 0.0);
  work.perWeight.resize(groups * lanes, 0.0);
  work.grip.resize(groups * lanes, 0.0);
  work.capacity = bonds.capacity;
  if (work.precision == Precision::Double) return;
  for (auto* v : {&work.x, &work.y, &work.z, &work.weight}) v->resize(room);
  if (bonds.twoFrames)
    for (auto* v : {&work.rx, &work.ry, &work.rz}) v->resize(room);
}

/// Rows behind the last owned one in its group: bonds to themselves of weight 0, so that the vector loops may read them.
void padLastGroup(ElasticWork& work, const Solids& solids, Bonds& bonds) {
  for (std::size_t s = solids.owned; s < groupsOf(solids) * lanes; s++) {
    work.rank[s] = 0;
    work.perTrace[s] = work.perWeight[s] = work.grip[s] = 0;
    work.singularLanes[s / lanes] = static_cast<std::uint8_t>(work.singularLanes[s / lanes] & ~(1u << s % lanes));
    for (int k = 0; k < bonds.capacity; k++) {
      const std::size_t b = bonds.at(s, k);
      bonds.neighbour[b] = static_cast<std::uint32_t>(s);
      bonds.weight[b] = bonds.x[b] = bonds.y[b] = bonds.z[b] = 0;
      if (bonds.twoFrames) bonds.rx[b] = bonds.ry[b] = bonds.rz[b] = 0;
      if (work.precision == Precision::Single) {
        work.weight[b] = work.x[b] = work.y[b] = work.z[b] = 0;
        if (bonds.twoFrames) work.rx[b] = work.ry[b] = work.rz[b] = 0;
      }
    }
  }
}

/// Number of places that the group's bonds take, and whether one of them has a remote end.
void lookAtGroup(ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t g) {
  std::size_t last = 0;
  bool remote = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(bonds.capacity); k++)
    for (std::size_t b = bonds.at(g * lanes, static_cast<int>(k)), end = b + lanes; b < end; b++) {
      if (!(bonds.weight[b] > 0)) continue;
      last = k + 1;
      remote = remote || bonds.neighbour[b] >= solids.owned;
    }
  work.bondCount[g] = static_cast<std::uint16_t>(last);
  work.remoteGroup[g] = remote;
}

void sortGroups(ElasticWork& work) {
  work.inner.clear();
  work.boundary.clear();
  for (std::size_t g = 0; g < work.remoteGroup.size(); g++) (work.remoteGroup[g] ? work.boundary : work.inner).push_back(static_cast<std::uint32_t>(g));
}

}  // namespace

std::int64_t refreshReference(ElasticWork& work, Solids& solids, Bonds& bonds, bool all) {
  all = all || work.capacity != bonds.capacity;  // places move when there is room for more bonds
  resizeWork(work, solids, bonds);
  padLastGroup(work, solids, bonds);
  for (std::size_t g = 0; g < groupsOf(solids); g++) {
    bool any = all;
    const std::size_t first = g * lanes, end = std::min(first + lanes, solids.owned);
    for (std::size_t s = first; s < end; s++) any = any || solids.changed[s];
    if (!any) continue;
    for (std::size_t s = first; s < end; s++)
      if (all || solids.changed[s]) refreshSlot(work, solids, bonds, s);
    lookAtGroup(work, solids, bonds, g);
  }
  sortGroups(work);
  return countSingular(work, solids);
}

}  // namespace thaw
