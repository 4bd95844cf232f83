// What the elastic step keeps of the bonds.
#include "core/solid/slot_state.hpp"

namespace thaw {

namespace {

void resizeWork(ElasticWork& work, const Solids& solids, Bonds& bonds) {
  const std::size_t groups = (solids.owned + lanes - 1) / lanes, room = groups * static_cast<std::size_t>(bonds.capacity) * lanes;
  work.bondCount.assign(groups, 0);
  work.singularLanes.assign(groups, 0);
  work.stretched.assign(groups, 0);
  work.rank.assign(groups * lanes, 0);
  work.perTrace.assign(groups * lanes, 0.0);
  work.perWeight.assign(groups * lanes, 0.0);
  if (work.precision == Precision::Single) {
    for (auto* v : {&work.x, &work.y, &work.z, &work.weight}) v->resize(room);
    if (bonds.twoFrames)
      for (auto* v : {&work.rx, &work.ry, &work.rz}) v->resize(room);
  }
  // rows behind the last owned one in its group: bonds to themselves of weight 0, so that the vector loops may read them
  for (std::size_t s = solids.owned; s < groups * lanes; s++)
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

void sortGroups(ElasticWork& work, const Solids& solids, const Bonds& bonds) {
  work.inner.clear();
  work.boundary.clear();
  for (std::size_t g = 0; g < work.bondCount.size(); g++) {
    bool remote = false;
    for (std::size_t b = bonds.at(g * lanes, 0), end = b + static_cast<std::size_t>(work.bondCount[g]) * lanes; b < end && !remote; b++)
      remote = bonds.neighbour[b] >= solids.owned && bonds.weight[b] > 0;
    (remote ? work.boundary : work.inner).push_back(static_cast<std::uint32_t>(g));
  }
}

}  // namespace

std::int64_t refreshReference(ElasticWork& work, Solids& solids, Bonds& bonds, bool all) {
  if (all) resizeWork(work, solids, bonds);
  for (std::size_t s = 0; s < solids.owned; s++)
    if (all || solids.changed[s]) refreshSlot(work, solids, bonds, s);
  if (all) sortGroups(work, solids, bonds);
  std::int64_t singular = 0;
  for (std::size_t s = 0; s < solids.owned; s++) singular += work.rank[s] < 3;
  return singular;
}

}  // namespace thaw
