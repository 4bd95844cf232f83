// SPDX-License-Identifier: Apache-2.0
#include "core/solid/bonds/bond_graph.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "core/solid/bonds/bond_entries.hpp"
#include "core/solid/bonds/solid_rows.hpp"

namespace thaw {

void BondGraph::begin() {
  before_ = ids_.size();
  now_.resize(before_);
  std::iota(now_.begin(), now_.end(), 0u);
  for (auto* v :
       {&leaving_, &departed_, &unnamed_, &movers_, &relocated_, &newRemotes_, &marked_, &lostBonds_})
    v->clear();
  aliases_.clear();
  released_.clear();
  fresh_.clear();
  isMarked_.assign(groupsOf(owned_), 0);
  turned_.assign(before_, 0);
}

void BondGraph::mark(std::size_t group) {
  if (group >= isMarked_.size()) isMarked_.resize(group + group / 4 + 8, 0);
  if (isMarked_[group]) return;
  isMarked_[group] = 1;
  marked_.push_back(static_cast<std::uint32_t>(group));
}

void BondGraph::removeRow(std::uint32_t row) {
  rowOf_.erase(ids_[row]);
  now_[row] = noRow;
}

void BondGraph::dropBroken(const SolidTables& t) {
  Bonds& b = t.bonds;
  references_.assign(before_, 0);  // the other end of a broken bond may be unknown by now, so all references
                                   // are recounted
  for (std::size_t s = 0; s < owned_; s++) {
    int kept = 0;
    const int used = used_[s];
    for (int k = 0; k < used; k++) {
      if (!b.hasBond(s, k)) continue;
      references_[b.neighbour[b.at(s, k)]]++;
      if (kept < k) copyBond(b, b.at(s, k), b.at(s, kept));
      kept++;
    }
    if (kept == used) continue;
    clearEntries(b, s, kept, used);
    used_[s] = static_cast<std::uint16_t>(kept);
    t.solids.changed[s] = 1;
    mark(s / lanes);
  }
  for (std::size_t r = owned_; r < before_; r++)
    if (references_[r] == 0) unnamed_.push_back(static_cast<std::uint32_t>(r));
}

void BondGraph::leave(const Bonds& b, std::uint32_t solidIndex) {
  if (solidIndex >= owned_)
    throw std::logic_error("rows were added to the table of solids outside of a rebuild of bonds");
  for (int k = 0; k < used_[solidIndex]; k++) {
    const std::uint32_t n = b.neighbour[b.at(solidIndex, k)];
    if (--references_[n] == 0 && n >= owned_) unnamed_.push_back(n);
  }
  removeRow(solidIndex);
  leaving_.push_back(solidIndex);
}

void BondGraph::depart(const Bonds& b, std::uint32_t solidIndex) {
  leave(b, solidIndex);
  departed_.push_back(solidIndex);
}

void BondGraph::remove(const Bonds& b, std::uint32_t solidIndex) { leave(b, solidIndex); }

std::uint32_t BondGraph::addRow(std::uint64_t id, int owner) {
  const auto row = static_cast<std::uint32_t>(ids_.size());
  ids_.push_back(id);
  owner_.push_back(owner);
  references_.push_back(0);
  now_.push_back(noRow);
  rowOf_.insert(id, row);
  return row;
}

std::uint32_t BondGraph::addRemote(std::uint64_t id, int owner) {
  const std::uint32_t row = addRow(id, owner);
  newRemotes_.push_back(row);
  return row;
}

void BondGraph::markOthers(const Bonds& b, std::uint32_t solidIndex) {
  for (int k = 0; k < used_[solidIndex]; k++) {
    const std::uint32_t n = b.neighbour[b.at(solidIndex, k)];
    if (n < owned_ && now_[n] != noRow) mark(now_[n] / lanes);
  }
}

void BondGraph::place(const SolidTables& t, std::span<const NewSolid> fresh, std::size_t remotesToCome) {
  Bonds& b = t.bonds;
  if (t.solids.owned != owned_ || t.solids.size() != before_)
    throw std::logic_error(
        "rows were added to or removed from the table of solids outside of a rebuild of bonds");
  std::sort(leaving_.begin(), leaving_.end());
  fresh_.assign(fresh.begin(), fresh.end());
  newOwned_ = owned_ - leaving_.size() + fresh.size();
  const std::size_t refilled = std::min(leaving_.size(), fresh.size());
  // The last remaining solids fill the holes that new solids leave.
  std::size_t hole = refilled;
  for (std::size_t s = newOwned_; s < owned_; s++)
    if (now_[s] != noRow) {
      now_[s] = leaving_[hole++];
      movers_.push_back(static_cast<std::uint32_t>(s));
    }
  for (const std::uint32_t s : leaving_) {
    markOthers(b, s);
    if (s / lanes < groupsOf(newOwned_)) mark(s / lanes);
  }
  for (const std::uint32_t s : movers_) {
    markOthers(b, s);
    mark(now_[s] / lanes);
    if (s / lanes < groupsOf(newOwned_)) mark(s / lanes);
  }
  for (const std::uint32_t s : movers_) {
    const std::uint32_t to = now_[s];
    copyRow(t.solids, s, to);
    for (int k = 0; k < used_[s]; k++) copyBond(b, b.at(s, k), b.at(to, k));
    clearEntries(b, to, used_[s], b.capacity);
    used_[to] = used_[s];
    t.solids.changed[to] = 1;
    t.particles.solidIndex[t.solids.particle[to]] = to;
  }
  for (std::size_t s = newOwned_; s < owned_; s++) {
    for (int k = 0; k < b.capacity; k++) clearBond(b, b.at(s, k), 0);
    used_[s] = 0;
  }
  resizeBonds(b, newOwned_, b.capacity);
  used_.resize(groupsOf(newOwned_) * lanes, 0);
  if (owned_ == 0 || remotesToCome > 0) {  // initial bonds: growth by doubling would take twice the memory
    const std::size_t rows = std::max(ids_.size() + fresh.size(), owned_ + remotesToCome);
    rowOf_.reserve(rows);
    ids_.reserve(rows);
    owner_.reserve(rows);
    references_.reserve(rows);
    now_.reserve(rows);
  }
  for (std::size_t i = 0; i < fresh.size(); i++) {
    const std::size_t solidIndex = i < refilled ? leaving_[i] : owned_ + (i - refilled);
    const std::uint64_t id = t.particles.id[fresh[i].particle];
    const std::uint32_t copy = rowOf_.find(id);
    const std::uint32_t row = addRow(id, rank_);
    now_[row] = static_cast<std::uint32_t>(solidIndex);
    if (copy != noRow) {  // a remote row that is now owned
      aliases_.push_back({copy, row});
      now_[copy] = static_cast<std::uint32_t>(solidIndex);
      turned_[copy] = 1;
    }
    clearEntries(b, solidIndex, 0, b.capacity);
    used_[solidIndex] = 0;
    mark(solidIndex / lanes);
  }
}

template<class Asked> std::size_t BondGraph::largestRowCount(std::span<const Asked> asked) const {
  std::size_t most = 0, first = 0;
  for (std::size_t k = 1; k <= asked.size(); k++) {
    const std::uint32_t solidIndex = asked[first].solidIndex;
    if (k < asked.size() && asked[k].solidIndex == solidIndex) continue;
    most = std::max(most, k - first + (solidIndex < owned_ ? used_[solidIndex] : 0));
    first = k;
  }
  return most;
}
std::size_t BondGraph::largestBondCount(std::span<const BondRequest> requests) const {
  return largestRowCount(requests);
}
std::size_t BondGraph::largestBondCount(std::span<const BondPair> pairs) const {
  return largestRowCount(pairs);
}

void BondGraph::reserve(Bonds& b, int capacity) const {
  if (capacity <= b.capacity) return;
  const int before = b.capacity;
  const std::size_t solidIndices = std::max(owned_, newOwned_);
  resizeBonds(b, solidIndices, (capacity + 3) / 4 * 4);
  for (std::size_t s = 0; s < newOwned_; s++) clearEntries(b, s, before, b.capacity);
}

void BondGraph::bond(const SolidTables& t, std::uint32_t from, const BondRecord& record, int owner,
                     std::uint32_t known) {
  const std::uint32_t solidIndex = now_[from];
  if (solidIndex == noRow) return;
  std::uint32_t other = known < owned_ && now_[known] != noRow ? known : rowOf_.find(record.neighbourId);
  if (other == from) return;
  if (other == noRow) {
    if (owner < 0 || owner == rank_) {
      if (from >= before_) lostBonds_.push_back(from);
      return;
    }
    other = addRemote(record.neighbourId, owner);
  }
  const int k = used_[solidIndex];
  if (k == t.bonds.capacity) reserve(t.bonds, k + 4);
  putBond(t.bonds, t.bonds.at(solidIndex, k), other, record);
  used_[solidIndex] = static_cast<std::uint16_t>(k + 1);
  references_[other]++;
  if (from < owned_)
    t.solids.changed[solidIndex] = 1;  // new solids are marked when their columns are created
  mark(solidIndex / lanes);
}

/// Appends bonds from pairs[first] on as long as they connect the same remaining solid to known, remaining
/// owned solids. This covers most initial bonds. Returns the index of the first pair that differs.
std::size_t BondGraph::bondOwned(const SolidTables& t, std::span<const BondPair> pairs, std::size_t first) {
  const std::uint32_t from = pairs[first].solidIndex, solidIndex = now_[from];
  if (solidIndex == noRow || t.bonds.vectors) return first;
  const std::size_t place = t.bonds.at(solidIndex, 0), room = static_cast<std::size_t>(t.bonds.capacity);
  std::uint32_t* const ends = t.bonds.neighbour.data();
  std::size_t i = first, used = used_[solidIndex];
  for (; i < pairs.size() && pairs[i].solidIndex == from && used < room; i++, used++) {
    const std::uint32_t other = pairs[i].other;
    if (other >= owned_ || other == from || now_[other] == noRow) break;
    ends[place + used * lanes] = other;
    references_[other]++;
  }
  if (i == first) return first;
  used_[solidIndex] = static_cast<std::uint16_t>(used);
  if (from < owned_) t.solids.changed[solidIndex] = 1;
  mark(solidIndex / lanes);
  return i;
}

void BondGraph::placeRemotes() {
  const auto alive = [&](std::size_t r) { return now_[r] == r && !turned_[r]; };
  for (const std::uint32_t d : departed_) {
    if (references_[d] == 0 || owner_[d] < 0) continue;
    std::uint32_t row = rowOf_.find(ids_[d]);
    if (row == noRow) row = addRemote(ids_[d], owner_[d]);
    aliases_.push_back({d, row});
    turned_[d] = 1;
  }
  for (const std::uint32_t r : unnamed_) {
    if (references_[r] > 0 || !alive(r)) continue;  // referenced again, removed, or now owned
    released_.push_back({ids_[r], owner_[r]});
    removeRow(r);
  }
  newRows_ = newOwned_ + newRemotes_.size();
  for (std::size_t r = owned_; r < before_; r++) newRows_ += alive(r);
  relocated_.clear();
  for (std::size_t r = owned_; r < before_; r++)
    if (alive(r) && (r < newOwned_ || r >= newRows_)) relocated_.push_back(static_cast<std::uint32_t>(r));
  std::size_t at = newOwned_;
  const auto nextFree = [&] {
    while (at >= owned_ && at < before_ && alive(at)) at++;
    return static_cast<std::uint32_t>(at++);
  };
  for (const std::uint32_t r : relocated_) now_[r] = nextFree();
  for (const std::uint32_t r : newRemotes_) now_[r] = nextFree();
  for (const Alias& a : aliases_) now_[a.row] = now_[a.replacement];
}

void findWithoutIndex(const BondedRows& p, Solids& s, std::vector<std::uint32_t>& withoutIndex) {
  withoutIndex.clear();
  if (s.owned == 0) withoutIndex.reserve(p.owned);  // at a start
  std::fill_n(s.particle.data(), s.owned, noParticle);
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::uint32_t solidIndex = p.solidIndex[i];
    const bool unbonded = p.unbonded(i);
    if (solidIndex == noSolid) {
      if (!unbonded) withoutIndex.push_back(static_cast<std::uint32_t>(i));
    } else if (unbonded) {
      p.solidIndex[i] = noSolid;
    } else {
      s.particle[solidIndex] = static_cast<std::uint32_t>(i);
    }
  }
}

}  // namespace thaw
