#include "core/solid/bond_graph.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "core/solid/bond_places.hpp"

namespace thaw {

namespace {

std::size_t groupsOf(std::size_t slots) { return (slots + lanes - 1) / lanes; }

void copyRow(Table& t, std::size_t from, std::size_t to) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memcpy(c->bytes.data() + to * c->elementBytes, c->bytes.data() + from * c->elementBytes, c->elementBytes);
}

void clearRow(Table& t, std::size_t row) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memset(c->bytes.data() + row * c->elementBytes, 0, c->elementBytes);
}

/// Places [from, to) of a slot hold no bond.
void clearPlaces(Bonds& b, std::size_t slot, int from, int to) {
  for (int k = from; k < to; k++) clearBond(b, b.at(slot, k), static_cast<std::uint32_t>(slot));
}

}  // namespace

void BondGraph::begin() {
  before_ = ids_.size();
  now_.resize(before_);
  std::iota(now_.begin(), now_.end(), 0u);
  for (auto* v : {&leaving_, &departed_, &unnamed_, &movers_, &relocated_, &newRemotes_, &marked_}) v->clear();
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

void BondGraph::forget(std::uint32_t row) {
  rowOf_.erase(ids_[row]);
  now_[row] = noRow;
}

void BondGraph::dropBroken(const SolidTables& t) {
  Bonds& b = t.bonds;
  for (std::size_t s = 0; s < owned_; s++) {
    int kept = 0;
    const int used = used_[s];
    for (int k = 0; k < used; k++) {
      const std::size_t at = b.at(s, k);
      if (b.weight[at] > 0) {
        if (kept < k) copyBond(b, at, b.at(s, kept));
        kept++;
        continue;
      }
      const std::uint32_t n = b.neighbour[at];
      if (--references_[n] == 0 && n >= owned_) unnamed_.push_back(n);
    }
    if (kept == used) continue;
    clearPlaces(b, s, kept, used);
    used_[s] = static_cast<std::uint16_t>(kept);
    t.solids.changed[s] = 1;
    mark(s / lanes);
  }
}

void BondGraph::leave(const Bonds& b, std::uint32_t slot) {
  for (int k = 0; k < used_[slot]; k++) {
    const std::uint32_t n = b.neighbour[b.at(slot, k)];
    if (--references_[n] == 0 && n >= owned_) unnamed_.push_back(n);
  }
  forget(slot);
  leaving_.push_back(slot);
}

void BondGraph::depart(const Bonds& b, std::uint32_t slot) {
  leave(b, slot);
  departed_.push_back(slot);
}

void BondGraph::remove(const Bonds& b, std::uint32_t slot) { leave(b, slot); }

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

void BondGraph::markOthers(const Bonds& b, std::uint32_t slot) {
  for (int k = 0; k < used_[slot]; k++) {
    const std::uint32_t n = b.neighbour[b.at(slot, k)];
    if (n < owned_ && now_[n] != noRow) mark(now_[n] / lanes);
  }
}

void BondGraph::place(const SolidTables& t, std::span<const NewSlot> fresh) {
  Bonds& b = t.bonds;
  if (t.solids.owned != owned_ || t.solids.size() != before_) throw std::logic_error("rows of the table of solids were added or removed outside of relink");
  std::sort(leaving_.begin(), leaving_.end());
  fresh_.assign(fresh.begin(), fresh.end());
  newOwned_ = owned_ - leaving_.size() + fresh.size();
  const std::size_t refilled = std::min(leaving_.size(), fresh.size());
  // the last slots that stay fill the holes that new ones leave
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
    clearPlaces(b, to, used_[s], b.capacity);
    used_[to] = used_[s];
    t.solids.changed[to] = 1;
    t.particles.slot[t.solids.particle[to]] = to;
  }
  for (std::size_t s = newOwned_; s < owned_; s++) {
    for (int k = 0; k < b.capacity; k++) clearBond(b, b.at(s, k), 0);
    used_[s] = 0;
  }
  resizeBonds(b, newOwned_, b.capacity);
  used_.resize(groupsOf(newOwned_) * lanes, 0);
  for (std::size_t i = 0; i < fresh.size(); i++) {
    const std::size_t slot = i < refilled ? leaving_[i] : owned_ + (i - refilled);
    const std::uint64_t id = t.particles.id[fresh[i].particle];
    const std::uint32_t copy = rowOf_.find(id);
    const std::uint32_t row = addRow(id, rank_);
    now_[row] = static_cast<std::uint32_t>(slot);
    if (copy != noRow) {  // a remote row that is owned now
      aliases_.push_back({copy, row});
      now_[copy] = static_cast<std::uint32_t>(slot);
      turned_[copy] = 1;
    }
    clearPlaces(b, slot, 0, b.capacity);
    used_[slot] = 0;
    mark(slot / lanes);
  }
}

void BondGraph::reserve(Bonds& b, int capacity) const {
  if (capacity <= b.capacity) return;
  const int before = b.capacity;
  const std::size_t slots = std::max(owned_, newOwned_);
  resizeBonds(b, slots, (capacity + 3) / 4 * 4);
  for (std::size_t s = 0; s < newOwned_; s++) clearPlaces(b, s, before, b.capacity);
}

void BondGraph::bond(const SolidTables& t, std::uint32_t from, const BondRecord& record, int owner) {
  const std::uint32_t slot = now_[from];
  if (slot == noRow) return;
  std::uint32_t other = rowOf_.find(record.neighbourId);
  if (other == from) return;
  if (other == noRow) {
    if (owner < 0 || owner == rank_) return;
    other = addRemote(record.neighbourId, owner);
  }
  const int k = used_[slot];
  if (k == t.bonds.capacity) reserve(t.bonds, k + 4);
  putBond(t.bonds, t.bonds.at(slot, k), other, record);
  used_[slot] = static_cast<std::uint16_t>(k + 1);
  references_[other]++;
  if (from < owned_) t.solids.changed[slot] = 1;  // new slots get it when their columns are made
  mark(slot / lanes);
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
    if (references_[r] > 0 || !alive(r)) continue;  // named again, removed, or owned now
    released_.push_back({ids_[r], owner_[r]});
    forget(r);
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
  for (const Alias& a : aliases_) now_[a.row] = now_[a.stands];
}

void BondGraph::moveColumns(const SolidTables& t) {
  Solids& s = t.solids;
  s.resize(s.owned, std::max(before_, newRows_) - s.owned);
  for (const std::uint32_t r : relocated_) copyRow(s, r, now_[r]);
  for (const std::uint32_t r : newRemotes_) {
    clearRow(s, now_[r]);
    s.id[now_[r]] = ids_[r];
    s.particle[now_[r]] = noParticle;
  }
  for (std::size_t i = 0; i < fresh_.size(); i++) {
    const std::uint32_t slot = now_[before_ + i], row = fresh_[i].particle;
    clearRow(s, slot);
    if (fresh_[i].state) s.unpackState(slot, fresh_[i].state);
    s.id[slot] = t.particles.id[row];
    s.material[slot] = t.particles.material[row];
    s.particle[slot] = row;
    s.changed[slot] = 1;
    t.particles.slot[row] = slot;
  }
  s.owned = newOwned_;
  s.resize(newOwned_, newRows_ - newOwned_);
}

std::int64_t BondGraph::walkGroup(const SolidTables& t, std::size_t g) {
  Bonds& b = t.bonds;
  const std::uint16_t* used = used_.data() + g * lanes;
  const int most = *std::max_element(used, used + lanes);
  std::int64_t met = 0;
  unsigned drops = 0;
  std::uint8_t boundary = 0;
  for (int k = 0; k < most; k++) {
    std::uint32_t* n = b.neighbour.data() + b.at(g * lanes, k);
    unsigned any = 0, remote = 0;
    for (int l = 0; l < lanes; l++) any |= touched_[n[l]];
    if (any)
      for (int l = 0; l < lanes; l++) {
        if (k >= used[l] || !touched_[n[l]]) continue;
        const std::uint32_t to = now_[n[l]];
        met++;
        if (to == noRow) drops |= 1u << l;
        else if ((n[l] >= owned_) != (to >= newOwned_)) t.solids.changed[g * lanes + static_cast<std::size_t>(l)] = 1;
        n[l] = to;
      }
    for (int l = 0; l < lanes; l++) remote |= n[l] >= newOwned_ && n[l] != noRow && k < used[l];
    boundary |= static_cast<std::uint8_t>(remote);
  }
  boundary_[g] = boundary;
  for (std::size_t l = 0; l < lanes; l++) {
    if (!(drops >> l & 1)) continue;
    const std::size_t s = g * lanes + l;
    int kept = 0;
    for (int k = 0; k < used_[s]; k++) {
      if (b.neighbour[b.at(s, k)] == noRow) continue;
      if (kept < k) copyBond(b, b.at(s, k), b.at(s, kept));
      kept++;
    }
    clearPlaces(b, s, kept, used_[s]);
    used_[s] = static_cast<std::uint16_t>(kept);
    t.solids.changed[s] = 1;
  }
  return met;
}

void BondGraph::walk(const SolidTables& t) {
  const std::size_t groups = groupsOf(newOwned_);
  touched_.assign(std::max(now_.size(), (std::max(groups, groupsOf(owned_)) + 1) * lanes), 0);
  std::int64_t expected = 0, met = 0;
  bool remotes = false;
  for (std::size_t r = 0; r < now_.size(); r++) {
    if (!renumbers(r)) continue;
    touched_[r] = 1;
    expected += references_[r];
    remotes = remotes || r >= owned_;
  }
  boundary_.resize(groups, 0);
  if (remotes)
    for (std::size_t g = 0; g < groups; g++)
      if (boundary_[g]) mark(g);
  for (std::size_t i = 0; i < marked_.size(); i++)
    if (marked_[i] < groups) met += walkGroup(t, marked_[i]);
  if (met != expected) {  // a bond whose other end does not have it: it may be anywhere
    isMarked_.resize(std::max(isMarked_.size(), groups), 0);
    for (std::size_t g = 0; g < groups; g++)
      if (!isMarked_[g]) met += walkGroup(t, g);
  }
  if (met != expected) throw std::logic_error("the bonds of a solid and the count of them disagree");
}

void BondGraph::renumber() {
  isAlias_.assign(now_.size(), 0);
  for (const Alias& a : aliases_) isAlias_[a.row] = 1;
  renumbered_.clear();
  for (std::size_t r = 0; r < now_.size(); r++)
    if (renumbers(r) && now_[r] != noRow) renumbered_.push_back({now_[r], references_[r], ids_[r], owner_[r], isAlias_[r] != 0});
  const std::size_t most = std::max(now_.size(), newRows_);
  ids_.resize(most);
  owner_.resize(most);
  references_.resize(most);
  for (const Renumbered& r : renumbered_) {
    if (r.alias) continue;
    ids_[r.to] = r.id;
    owner_[r.to] = r.owner;
    references_[r.to] = 0;
    rowOf_.insert(r.id, r.to);
  }
  for (const Renumbered& r : renumbered_) references_[r.to] += r.references;
  ids_.resize(newRows_);
  owner_.resize(newRows_);
  references_.resize(newRows_);
}

void BondGraph::finish(const SolidTables& t) {
  placeRemotes();
  moveColumns(t);
  walk(t);
  renumber();
  for (std::uint32_t& r : newRemotes_) r = now_[r];
  owned_ = newOwned_;
}

void BondGraph::check(const SolidTables& t) const {
  const auto fail = [](const char* what) { throw std::logic_error(what); };
  const Bonds& b = t.bonds;
  const std::size_t rows = ids_.size(), groups = groupsOf(owned_);
  if (t.solids.owned != owned_ || t.solids.size() != rows || owner_.size() != rows || references_.size() != rows) fail("number of rows");
  if (rowOf_.size() != rows || used_.size() != groups * lanes || boundary_.size() != groups) fail("number of ids or groups");
  if (b.weight.size() < groups * lanes * static_cast<std::size_t>(b.capacity)) fail("room for bonds");
  std::vector<std::uint32_t> references(rows, 0);
  std::vector<std::uint8_t> boundary(groups, 0);
  for (std::size_t r = 0; r < rows; r++) {
    if (rowOf_.find(ids_[r]) != r || t.solids.id[r] != ids_[r]) fail("id of a row");
    if ((owner_[r] == rank_) != (r < owned_)) fail("owner of a row");
    if (r >= owned_ && t.solids.particle[r] != noParticle) fail("particle of a remote row");
    if (r < owned_ && t.particles.slot[t.solids.particle[r]] != r) fail("particle of a slot");
  }
  for (std::size_t s = 0; s < groups * lanes; s++)
    for (int k = 0; k < b.capacity; k++) {
      const std::size_t at = b.at(s, k);
      if (k < used_[s]) {
        if (b.neighbour[at] >= rows || b.neighbour[at] == s) fail("end of a bond");
        references[b.neighbour[at]]++;
        if (b.neighbour[at] >= owned_) boundary[s / lanes] = 1;
      } else if (b.weight[at] != 0 || b.x[at] != 0 || (s < owned_ ? b.neighbour[at] != s : b.neighbour[at] >= groups * lanes)) {
        fail("a place without bond");
      }
    }
  if (references != references_) fail("count of references");
  if (boundary != boundary_) fail("boundary groups");
  for (std::size_t r = owned_; r < rows; r++)
    if (references_[r] == 0) fail("a remote row that nobody names");
}

void findUnslotted(Continuum& p, Solids& s, std::vector<std::uint32_t>& unslotted) {
  unslotted.clear();
  std::fill_n(s.particle.data(), s.owned, noParticle);
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::uint32_t slot = p.slot[i];
    const bool liquid = p.phase[i] == Liquid;
    if (slot == noSlot) {
      if (!liquid) unslotted.push_back(static_cast<std::uint32_t>(i));
    } else if (liquid) {
      p.slot[i] = noSlot;
    } else {
      s.particle[slot] = static_cast<std::uint32_t>(i);
    }
  }
}

}  // namespace thaw
