// SPDX-License-Identifier: Apache-2.0
// The last part of a bond update. Rows and bonds move to the positions that bond_graph.cpp assigned.
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "core/solid/bonds/bond_entries.hpp"
#include "core/solid/bonds/bond_graph.hpp"
#include "core/solid/bonds/solid_rows.hpp"

namespace thaw {

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
    const std::uint32_t solidIndex = now_[before_ + i], row = fresh_[i].particle;
    clearRow(s, solidIndex);
    if (fresh_[i].state) s.unpackState(solidIndex, fresh_[i].state);
    s.id[solidIndex] = t.particles.id[row];
    s.material[solidIndex] = t.particles.material[row];
    s.particle[solidIndex] = row;
    s.changed[solidIndex] = 1;
    t.particles.solidIndex[row] = solidIndex;
  }
  for (const std::uint32_t r : lostBonds_) s.markExposed(now_[r]);
  s.owned = newOwned_;
  s.resize(newOwned_, newRows_ - newOwned_);
}

std::int64_t BondGraph::rebuildGroup(const SolidTables& t, std::size_t g) {
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
        else if ((n[l] >= owned_) != (to >= newOwned_))
          t.solids.changed[g * lanes + static_cast<std::size_t>(l)] = 1;
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
    clearEntries(b, s, kept, used_[s]);
    used_[s] = static_cast<std::uint16_t>(kept);
    t.solids.changed[s] = 1;
    t.solids.markExposed(s);
  }
  return met;
}

void BondGraph::rebuildGroups(const SolidTables& t) {
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
    if (marked_[i] < groups) met += rebuildGroup(t, marked_[i]);
  if (met != expected) {  // a bond has no counterpart at its other end, so it may be in any group
    isMarked_.resize(std::max(isMarked_.size(), groups), 0);
    for (std::size_t g = 0; g < groups; g++)
      if (!isMarked_[g]) met += rebuildGroup(t, g);
  }
  if (met != expected) throw std::logic_error("the bonds of solids disagree with their reference counts");
}

void BondGraph::renumber() {
  isAlias_.assign(now_.size(), 0);
  for (const Alias& a : aliases_) isAlias_[a.row] = 1;
  renumbered_.clear();
  for (std::size_t r = 0; r < now_.size(); r++)
    if (renumbers(r) && now_[r] != noRow)
      renumbered_.push_back({now_[r], references_[r], ids_[r], owner_[r], isAlias_[r] != 0});
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
  rebuildGroups(t);
  renumber();
  for (std::uint32_t& r : newRemotes_) r = now_[r];
  owned_ = newOwned_;
}

std::size_t BondGraph::bytes() const {
  const auto of = [](const auto&... v) { return (std::size_t(0) + ... + (v.capacity() * sizeof(v[0]))); };
  return rowOf_.bytes() + of(ids_, owner_, references_, used_, boundary_, now_, leaving_, departed_, movers_,
                             unnamed_, relocated_, newRemotes_, lostBonds_, aliases_, released_, fresh_,
                             marked_, isMarked_, touched_, isAlias_, turned_, renumbered_);
}

void BondGraph::check(const SolidTables& t) const {
  const auto fail = [](const char* what) {
    throw std::logic_error(std::string("internal error: the bond graph disagrees with the solids (") + what +
                           "); please report it");
  };
  const Bonds& b = t.bonds;
  const std::size_t rows = ids_.size(), groups = groupsOf(owned_);
  if (t.solids.owned != owned_ || t.solids.size() != rows || owner_.size() != rows ||
      references_.size() != rows)
    fail("number of rows");
  if (rowOf_.size() != rows || used_.size() != groups * lanes || boundary_.size() != groups)
    fail("number of ids or groups");
  if (b.neighbour.size() < groups * lanes * static_cast<std::size_t>(b.capacity)) fail("capacity for bonds");
  std::vector<std::uint32_t> references(rows, 0);
  std::vector<std::uint8_t> boundary(groups, 0);
  for (std::size_t r = 0; r < rows; r++) {
    if (rowOf_.find(ids_[r]) != r || t.solids.id[r] != ids_[r]) fail("id of a row");
    if ((owner_[r] == rank_) != (r < owned_)) fail("owner of a row");
    if (r >= owned_ && t.solids.particle[r] != noParticle) fail("particle of a remote row");
    if (r < owned_ && t.particles.solidIndex[t.solids.particle[r]] != r) fail("particle of a solidIndex");
  }
  for (std::size_t s = 0; s < groups * lanes; s++)
    for (int k = 0; k < b.capacity; k++) {
      const std::size_t at = b.at(s, k);
      if (k < used_[s]) {
        if (b.neighbour[at] >= rows || b.neighbour[at] == s) fail("end of a bond");
        references[b.neighbour[at]]++;
        if (b.neighbour[at] >= owned_) boundary[s / lanes] = 1;
      } else if ((b.vectors && (b.weight[at] != 0 || b.x[at] != 0)) ||
                 (s < owned_ ? b.neighbour[at] != s : b.neighbour[at] >= groups * lanes)) {
        fail("an unused bond entry");
      }
    }
  if (references != references_) fail("count of references");
  if (boundary != boundary_) fail("boundary groups");
  for (std::size_t r = owned_; r < rows; r++)
    if (references_[r] == 0) fail("a remote row without references");
}

}  // namespace thaw
