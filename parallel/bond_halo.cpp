// SPDX-License-Identifier: Apache-2.0
#include "parallel/bond_halo.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace thaw {

namespace {

enum Flag { Changed = 1, Membership = 2, Unknown = 4 };

}  // namespace

std::vector<Message> MpiBondHalo::exchange(const std::vector<Message>& out, int kind) {
  return sparseExchange(comm_, out, kind, MessagesFor::BondEdits);
}

/// Returns the bitwise or over all ranks.
int MpiBondHalo::anyRank(int bits) const {
  const WaitMark waiting(comm_, MessagesFor::Reduction);
  MPI_Allreduce(MPI_IN_PLACE, &bits, 1, MPI_INT, MPI_BOR, comm_.handle());
  comm_.statistics().collectives++;
  return bits;
}

void MpiBondHalo::adopt(std::vector<std::byte> records) {
  pendingRecords_.push_back({std::move(records), {}, true});
}

bool MpiBondHalo::rebuildBonds(const BondedRows& p, Solids& s, Bonds& b, const BondUpdate& work) {
  if (!p.active) return false;
  const SolidTables tables{p, s, b};
  const bool alone = comm_.size() == 1;
  withoutIndex_.clear();
  removed_.clear();
  meltedArrivals_.clear();
  fresh_.clear();
  recordOf_.clear();
  queriedIds_.clear();
  const bool particlesChanged = moved_ || work.changedHere || solidArrived_ || !pendingRecords_.empty();
  const bool edit = particlesChanged || work.asks() || b.broken;
  int flags = edit ? Changed : 0;
  std::vector<std::uint64_t> unknown;
  if (edit) {
    graph_.begin();
    if (b.broken) graph_.dropBroken(tables);
    if (particlesChanged) {
      findWithoutIndex(p, s, withoutIndex_);
      listPendingRecords(s);
      leaveSolids(s, b);
    }
    matchRecords(p);
    bool membership = !removed_.empty() || !meltedArrivals_.empty();
    for (const Found* f : recordOf_) membership = membership || !f || pendingRecords_[f->waiting].adopted;
    if (membership) flags |= Membership;
    unknown = unknownIds(s, work, false);
    if (!unknown.empty()) flags |= Unknown;
  }
  if (!alone) flags = anyRank(flags);
  if (!(flags & Changed)) return false;
  if (!edit) graph_.begin();
  if (!alone) {
    if (flags & Membership) sendChanges(p);
    if (moved_ && (flags & Membership)) checkMoves(s, work);
    else if (flags & Unknown) queryOwners(unknown);
  }
  makeSolids(tables, work);
  graph_.finish(tables);
  if (!alone) links_.renew(comm_, graph_);
  departures_.clear();
  pendingRecords_.clear();
  found_.clear();
  movedRows_.clear();
  moved_ = solidArrived_ = false;
  b.broken = false;
  return true;
}

void MpiBondHalo::sendChanges(const BondedRows& p) {
  WordMessages updates;
  const auto setOwner = [&](std::uint64_t id, std::uint64_t owner) {
    std::vector<std::uint64_t>& w = updates.to(directoryRank(id, comm_.size()));
    w.push_back(id);
    w.push_back(owner);
  };
  // A particle that melts and freezes at once is removed from the directory before it is written again.
  for (const std::uint32_t solidIndex : removed_) setOwner(graph_.idOf(solidIndex), SolidDirectory::noOwner);
  for (const std::uint64_t id : meltedArrivals_) setOwner(id, SolidDirectory::noOwner);
  links_.announceRemovals(graph_, removed_, updates);
  for (std::size_t i = 0; i < fresh_.size(); i++)
    if (!recordOf_[i] || pendingRecords_[recordOf_[i]->waiting].adopted)
      setOwner(p.id[fresh_[i].particle], static_cast<std::uint64_t>(comm_.rank()));
  applyUpdates(exchange(updates.messages(), UpdateKind), true);
}

/// Returns ids at the other ends of new bonds without a row here and with unknown owner (all: also those
/// whose record names the owner).
std::vector<std::uint64_t> MpiBondHalo::unknownIds(const Solids& s, const BondUpdate& work, bool all) {
  std::vector<std::uint64_t> ids;
  SolidRecordView view;
  for (const Found* f : recordOf_) {
    if (!f || (!all && !pendingRecords_[f->waiting].adopted)) continue;
    readRecord(s, pendingRecords_[f->waiting].records, f->at, view);
    for (const BondRecord& r : view.bonds)
      if (graph_.rowOf(r.neighbourId) == noRow) ids.push_back(r.neighbourId);
  }
  const auto listUnknown = [&](const auto& asked) {
    for (const auto& q : asked)
      if ((q.other == noSolid || graph_.leaves(q.other)) && graph_.rowOf(q.neighbourId) == noRow)
        ids.push_back(q.neighbourId);
  };
  listUnknown(work.requests);
  listUnknown(work.pairs);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void MpiBondHalo::queryOwners(const std::vector<std::uint64_t>& ids) {
  WordMessages ask;
  for (const std::uint64_t id : ids) ask.to(directoryRank(id, comm_.size())).push_back(id);
  WordMessages answer;
  for (const Message& m : exchange(ask.messages(), QueryKind))
    for (const std::uint64_t id : wordsOf(m)) {
      answer.to(m.rank).push_back(id);
      answer.to(m.rank).push_back(directory_.find(id));
    }
  std::vector<std::pair<std::uint64_t, std::uint64_t>> found;
  for (const Message& m : exchange(answer.messages(), AnswerKind)) {
    const std::vector<std::uint64_t> w = wordsOf(m);
    for (std::size_t k = 0; k + 1 < w.size(); k += 2) found.push_back({w[k], w[k + 1]});
  }
  std::sort(found.begin(), found.end());
  queriedIds_.clear();
  queriedOwners_.clear();
  for (const auto& [id, owner] : found) {
    queriedIds_.push_back(id);
    queriedOwners_.push_back(owner);
  }
}

// Handles particles that migrated and particles that stopped being solid before the same bond update: owners
// announced in the migration may be outdated.
void MpiBondHalo::checkMoves(const Solids& s, const BondUpdate& work) {
  std::vector<std::uint64_t> ids = unknownIds(s, work, true);
  for (const Departure& d : departures_) ids.push_back(graph_.idOf(d.solidIndex));
  for (const std::uint32_t row : movedRows_) ids.push_back(graph_.idOf(row));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  queryOwners(ids);
  for (const Departure& d : departures_)
    if (ownerOf(graph_.idOf(d.solidIndex)) < 0) graph_.setOwner(d.solidIndex, -1);
  for (const std::uint32_t row : movedRows_)
    if (ownerOf(graph_.idOf(row)) < 0 && graph_.rowOf(graph_.idOf(row)) == row) graph_.removeRemote(row);
}

/// Returns the owner from the directory's answer; -1 if it has none, -2 if the id was not requested.
int MpiBondHalo::ownerOf(std::uint64_t id) const {
  const auto at = std::lower_bound(queriedIds_.begin(), queriedIds_.end(), id);
  if (at == queriedIds_.end() || *at != id) return -2;
  const std::uint64_t owner = queriedOwners_[static_cast<std::size_t>(at - queriedIds_.begin())];
  return owner == SolidDirectory::noOwner ? -1 : static_cast<int>(owner);
}

void MpiBondHalo::makeSolids(const SolidTables& t, const BondUpdate& work) {
  SolidRecordView view;
  std::size_t most = 0;
  for (std::size_t i = 0; i < fresh_.size(); i++) {
    if (!recordOf_[i]) continue;
    readRecord(t.solids, pendingRecords_[recordOf_[i]->waiting].records, recordOf_[i]->at, view);
    fresh_[i].state = view.state;
    most = std::max(most, view.bonds.size());
  }
  most = std::max({most, graph_.largestBondCount(work.requests), graph_.largestBondCount(work.pairs)});
  // If later parts of a start need little more, reserve all capacity at once: each increase reallocates all
  // bonds.
  constexpr int little = 4;
  if (work.mostToCome > t.bonds.capacity && work.mostToCome <= static_cast<int>(most + 3) / 4 * 4 + little)
    most = std::max<std::size_t>(most, static_cast<std::size_t>(work.mostToCome));
  const auto before = static_cast<std::uint32_t>(graph_.rows());
  graph_.place(t, fresh_, work.remotesToCome);
  graph_.reserve(t.bonds, static_cast<int>(most));
  for (std::uint32_t i = 0; i < fresh_.size(); i++) {
    const Found* f = recordOf_[i];
    if (!f) continue;
    const PendingRecords& w = pendingRecords_[f->waiting];
    readRecord(t.solids, w.records, f->at, view);
    std::size_t nextOwner = f->owner;
    for (const BondRecord& r : view.bonds) {
      int owner = ownerOf(r.neighbourId);
      if (owner == -2 && !w.adopted) owner = w.owners[nextOwner];
      nextOwner++;
      graph_.bond(t, before + i, r, owner);
    }
  }
  const auto ownerOfEnd = [&](const auto& q) {
    return q.other != noSolid && !graph_.leaves(q.other) ? comm_.rank() : ownerOf(q.neighbourId);
  };
  for (const BondRequest& q : work.requests) graph_.bond(t, q.solidIndex, bondOf(q), ownerOfEnd(q), q.other);
  graph_.bond(t, work.pairs, ownerOfEnd);
}

void MpiBondHalo::begin(Solids&, std::span<AnyColumn* const> columns) { links_.begin(comm_, columns); }
void MpiBondHalo::finish(Solids&) { links_.finish(comm_); }

}  // namespace thaw
