#include "parallel/bond_halo.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace thaw {

namespace {

enum Kind { RecordKind = 40, NewsKind = 41, QueryKind = 42, AnswerKind = 43 };
enum Flag { Changed = 1, Membership = 2, Unknown = 4 };

}  // namespace

std::vector<Message> MpiBondHalo::exchange(const std::vector<Message>& out, int kind) {
  return sparseExchange(comm_, out, kind, MessagesFor::BondEdits);
}

/// Bits that some rank has set.
int MpiBondHalo::anyRank(int bits) const {
  const WaitMark waiting(comm_, MessagesFor::Reduction);
  MPI_Allreduce(MPI_IN_PLACE, &bits, 1, MPI_INT, MPI_BOR, comm_.handle());
  comm_.traffic().collectives++;
  return bits;
}

void MpiBondHalo::adopt(std::vector<std::byte> records) { waiting_.push_back({std::move(records), {}, true}); }

void MpiBondHalo::listWaiting(const Solids& s) {
  found_.clear();
  SolidRecordView view;
  for (std::size_t w = 0; w < waiting_.size(); w++) {
    std::size_t owner = 0;
    for (std::size_t at = 0; at < waiting_[w].records.size();) {
      const std::size_t end = readRecord(s, waiting_[w].records, at, view);
      found_.push_back({view.id, w, at, end, owner});
      owner += view.bonds.size();
      at = end;
    }
    if (!waiting_[w].adopted && owner != waiting_[w].owners.size()) throw std::runtime_error("the records of solid particles and their owners disagree");
  }
  std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) { return a.id < b.id; });
}

const MpiBondHalo::Found* MpiBondHalo::findWaiting(std::uint64_t id) const {
  const auto at = std::lower_bound(found_.begin(), found_.end(), id, [](const Found& f, std::uint64_t i) { return f.id < i; });
  return at != found_.end() && at->id == id ? &*at : nullptr;
}

void MpiBondHalo::migrate(const BondedRows& p, Solids& s, Bonds& b, const Migration& m) {
  if (!p.active) return;
  if (moved_) throw std::logic_error("solid particles migrate twice without a relink between");
  for (std::size_t i = p.owned - m.arrivals; i < p.owned; i++) {
    p.slot[i] = noSlot;
    solidArrived_ = solidArrived_ || !p.liquid(i);  // perhaps frozen before it went, and nobody here would look for it
  }
  if (comm_.size() == 1) return;
  int any = 0;
  for (std::size_t k = 0; k < m.departed.size(); k++) {
    if (m.departedTo[k] < 0) continue;  // left the domain: relink misses it
    if (p.liquid(m.departed[k])) continue;  // melted before it went: the same
    const std::uint32_t slot = p.slot[m.departed[k]];
    if (slot != noSlot) departures_.push_back({slot, m.departedTo[k]});
    else any = any || !waiting_.empty();
  }
  any = any || !departures_.empty();
  any = anyRank(any);
  if (!any) return;
  moved_ = true;
  tellDepartures();
  sendRecords(p, s, b, m);
}

// To ranks that copy a particle, and to its entry in the directory: who owns it now. Before the records are sent, so that these
// can say where the other ends of bonds are once all have moved.
void MpiBondHalo::tellDepartures() {
  for (const Departure& d : departures_) graph_.setOwner(d.slot, d.to);
  WordMessages news;
  for (const Departure& d : departures_) {
    std::vector<std::uint64_t>& w = news.to(directoryRank(graph_.idOf(d.slot), comm_.size()));
    w.push_back(graph_.idOf(d.slot));
    w.push_back(static_cast<std::uint64_t>(d.to));
  }
  links_.announceDepartures(graph_, comm_.rank(), news);
  applyNews(exchange(news.messages(), NewsKind), false);
}

void MpiBondHalo::applyNews(const std::vector<Message>& in, bool edit) {
  for (const Message& m : in) {
    const std::vector<std::uint64_t> w = wordsOf(m);
    for (std::size_t k = 0; k + 1 < w.size(); k += 2) {
      const std::uint64_t id = w[k], owner = w[k + 1];
      if (directoryRank(id, comm_.size()) == comm_.rank()) directory_.set(id, owner, m.rank);
      const std::uint32_t row = graph_.rowOf(id);
      if (row == noRow || !graph_.isRemote(row)) continue;
      if (owner == SolidDirectory::nobody) {
        graph_.removeRemote(row);
      } else if (!edit) {
        graph_.setOwner(row, static_cast<int>(owner));
        movedRows_.push_back(row);
      }
    }
  }
}

void MpiBondHalo::sendRecords(const BondedRows& p, const Solids& s, const Bonds& b, const Migration& m) {
  struct Parcel { int to; SolidRecords records; std::vector<std::int32_t> owners; bool adopted; };
  std::vector<Parcel> parcels;
  const auto parcelTo = [&](int to, bool adopted) -> Parcel& {
    const auto at = std::find_if(parcels.begin(), parcels.end(),
                                 [&](const Parcel& x) { return x.to == to && x.adopted == adopted; });
    return at != parcels.end() ? *at : parcels.emplace_back(Parcel{to, {}, {}, adopted});
  };
  for (const Departure& d : departures_) {
    Parcel& x = parcelTo(d.to, false);
    appendRecord(s, b, d.slot, x.records);
    for (int k = 0; k < b.capacity; k++)
      if (b.there(d.slot, k)) x.owners.push_back(graph_.ownerOf(b.neighbour[b.at(d.slot, k)]));
  }
  if (!waiting_.empty()) {
    listWaiting(s);
    for (std::size_t k = 0; k < m.departed.size(); k++) {
      if (m.departedTo[k] < 0 || p.slot[m.departed[k]] != noSlot) continue;
      const Found* f = findWaiting(p.id[m.departed[k]]);
      if (!f) continue;
      std::vector<std::byte>& bytes = parcelTo(m.departedTo[k], true).records.bytes;
      const std::vector<std::byte>& from = waiting_[f->waiting].records;
      bytes.insert(bytes.end(), from.begin() + static_cast<std::ptrdiff_t>(f->at), from.begin() + static_cast<std::ptrdiff_t>(f->end));
    }
  }
  std::vector<Message> out;
  for (const Parcel& x : parcels) {
    const std::uint64_t head[2] = {x.records.bytes.size(), x.adopted};
    std::vector<std::byte> bytes(sizeof head + head[0] + x.owners.size() * sizeof(std::int32_t));
    std::memcpy(bytes.data(), head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, x.records.bytes.data(), head[0]);
    if (!x.owners.empty()) std::memcpy(bytes.data() + sizeof head + head[0], x.owners.data(), x.owners.size() * sizeof(std::int32_t));
    out.push_back({x.to, std::move(bytes)});
  }
  for (const Message& message : exchange(out, RecordKind)) {
    std::uint64_t head[2];
    std::memcpy(head, message.bytes.data(), sizeof head);
    Waiting w;
    w.adopted = head[1] != 0;
    const auto first = message.bytes.begin() + sizeof head, last = first + static_cast<std::ptrdiff_t>(head[0]);
    w.records.assign(first, last);
    w.owners.resize(static_cast<std::size_t>(message.bytes.end() - last) / sizeof(std::int32_t));
    if (!w.owners.empty()) std::memcpy(w.owners.data(), &*last, w.owners.size() * sizeof(std::int32_t));
    waiting_.push_back(std::move(w));
  }
}

// Begins the edit of the graph: who leaves, who comes.
void MpiBondHalo::leaveSlots(const Solids& s, const Bonds& b) {
  for (const Departure& d : departures_) graph_.depart(b, d.slot);
  removed_.clear();
  for (std::uint32_t slot = 0; slot < s.owned; slot++)
    if (s.particle[slot] == noParticle && !graph_.leaves(slot)) removed_.push_back(slot);
  for (const std::uint32_t slot : removed_) graph_.remove(b, slot);
}

// Particles without a slot and the records that came for them.
void MpiBondHalo::matchRecords(const BondedRows& p) {
  std::vector<std::uint8_t> used(found_.size(), 0);
  for (const std::uint32_t row : unslotted_) {
    const Found* f = findWaiting(p.id[row]);
    if (f) used[static_cast<std::size_t>(f - found_.data())] = 1;
    recordOf_.push_back(f);
    fresh_.push_back({row, nullptr});
  }
  for (std::size_t k = 0; k < found_.size(); k++)
    if (!used[k] && !waiting_[found_[k].waiting].adopted) strangers_.push_back(found_[k].id);
}

bool MpiBondHalo::relink(const BondedRows& p, Solids& s, Bonds& b, const Relink& work) {
  if (!p.active) return false;
  const SolidTables tables{p, s, b};
  const bool alone = comm_.size() == 1;
  unslotted_.clear();
  removed_.clear();
  strangers_.clear();
  fresh_.clear();
  recordOf_.clear();
  askedIds_.clear();
  const bool particlesChanged = moved_ || work.changedHere || solidArrived_ || !waiting_.empty();
  const bool edit = particlesChanged || !work.requests.empty() || b.broken;
  int flags = edit ? Changed : 0;
  std::vector<std::uint64_t> unknown;
  if (edit) {
    graph_.begin();
    if (b.broken) graph_.dropBroken(tables);
    if (particlesChanged) {
      findUnslotted(p, s, unslotted_);
      listWaiting(s);
      leaveSlots(s, b);
    }
    matchRecords(p);
    bool membership = !removed_.empty() || !strangers_.empty();
    for (const Found* f : recordOf_) membership = membership || !f || waiting_[f->waiting].adopted;
    if (membership) flags |= Membership;
    unknown = unknownIds(s, work, false);
    if (!unknown.empty()) flags |= Unknown;
  }
  if (!alone) flags = anyRank(flags);
  if (!(flags & Changed)) return false;
  if (!edit) graph_.begin();
  if (!alone) {
    if (flags & Membership) tellChanges(p);
    if (moved_ && (flags & Membership)) checkMoves(s, work);
    else if (flags & Unknown) askOwners(unknown);
  }
  makeSlots(tables, work);
  graph_.finish(tables);
  if (!alone) links_.renew(comm_, graph_);
  departures_.clear();
  waiting_.clear();
  found_.clear();
  movedRows_.clear();
  moved_ = solidArrived_ = false;
  b.broken = false;
  return true;
}

void MpiBondHalo::tellChanges(const BondedRows& p) {
  WordMessages news;
  const auto tell = [&](std::uint64_t id, std::uint64_t owner) {
    std::vector<std::uint64_t>& w = news.to(directoryRank(id, comm_.size()));
    w.push_back(id);
    w.push_back(owner);
  };
  // a particle that melts and freezes at once is struck out before it is written
  for (const std::uint32_t slot : removed_) tell(graph_.idOf(slot), SolidDirectory::nobody);
  for (const std::uint64_t id : strangers_) tell(id, SolidDirectory::nobody);
  links_.announceRemovals(graph_, removed_, news);
  for (std::size_t i = 0; i < fresh_.size(); i++)
    if (!recordOf_[i] || waiting_[recordOf_[i]->waiting].adopted) tell(p.id[fresh_[i].particle], static_cast<std::uint64_t>(comm_.rank()));
  applyNews(exchange(news.messages(), NewsKind), true);
}

/// Ids at the far ends of bonds to be made that no row here has and whose owner nobody told (all: also where a record tells it).
std::vector<std::uint64_t> MpiBondHalo::unknownIds(const Solids& s, const Relink& work, bool all) {
  std::vector<std::uint64_t> ids;
  SolidRecordView view;
  for (const Found* f : recordOf_) {
    if (!f || (!all && !waiting_[f->waiting].adopted)) continue;
    readRecord(s, waiting_[f->waiting].records, f->at, view);
    for (const BondRecord& r : view.bonds)
      if (graph_.rowOf(r.neighbourId) == noRow) ids.push_back(r.neighbourId);
  }
  for (const BondRequest& q : work.requests)
    if ((q.other == noSlot || graph_.leaves(q.other)) && graph_.rowOf(q.neighbourId) == noRow) ids.push_back(q.neighbourId);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void MpiBondHalo::askOwners(const std::vector<std::uint64_t>& ids) {
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
  askedIds_.clear();
  askedOwners_.clear();
  for (const auto& [id, owner] : found) {
    askedIds_.push_back(id);
    askedOwners_.push_back(owner);
  }
}

// Particles migrated and others, or the same, stopped being solid before this relink: what was told in the migration is out of date.
void MpiBondHalo::checkMoves(const Solids& s, const Relink& work) {
  std::vector<std::uint64_t> ids = unknownIds(s, work, true);
  for (const Departure& d : departures_) ids.push_back(graph_.idOf(d.slot));
  for (const std::uint32_t row : movedRows_) ids.push_back(graph_.idOf(row));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  askOwners(ids);
  for (const Departure& d : departures_)
    if (ownerOf(graph_.idOf(d.slot)) < 0) graph_.setOwner(d.slot, -1);
  for (const std::uint32_t row : movedRows_)
    if (ownerOf(graph_.idOf(row)) < 0 && graph_.rowOf(graph_.idOf(row)) == row) graph_.removeRemote(row);
}

/// The directory's answer; -1 where it knows nobody, -2 where it was not asked.
int MpiBondHalo::ownerOf(std::uint64_t id) const {
  const auto at = std::lower_bound(askedIds_.begin(), askedIds_.end(), id);
  if (at == askedIds_.end() || *at != id) return -2;
  const std::uint64_t owner = askedOwners_[static_cast<std::size_t>(at - askedIds_.begin())];
  return owner == SolidDirectory::nobody ? -1 : static_cast<int>(owner);
}

void MpiBondHalo::makeSlots(const SolidTables& t, const Relink& work) {
  SolidRecordView view;
  std::size_t most = 0;
  for (std::size_t i = 0; i < fresh_.size(); i++) {
    if (!recordOf_[i]) continue;
    readRecord(t.solids, waiting_[recordOf_[i]->waiting].records, recordOf_[i]->at, view);
    fresh_[i].state = view.state;
    most = std::max(most, view.bonds.size());
  }
  most = std::max(most, graph_.mostBonds(work.requests));
  const auto before = static_cast<std::uint32_t>(graph_.rows());
  graph_.place(t, fresh_);
  graph_.reserve(t.bonds, static_cast<int>(most));
  for (std::uint32_t i = 0; i < fresh_.size(); i++) {
    const Found* f = recordOf_[i];
    if (!f) continue;
    const Waiting& w = waiting_[f->waiting];
    readRecord(t.solids, w.records, f->at, view);
    std::size_t told = f->owner;
    for (const BondRecord& r : view.bonds) {
      int owner = ownerOf(r.neighbourId);
      if (owner == -2 && !w.adopted) owner = w.owners[told];
      told++;
      graph_.bond(t, before + i, r, owner);
    }
  }
  for (const BondRequest& q : work.requests) {
    const bool here = q.other != noSlot && !graph_.leaves(q.other);
    graph_.bond(t, q.slot, bondOf(q), here ? comm_.rank() : ownerOf(q.neighbourId), q.other);
  }
}

void MpiBondHalo::begin(Solids&, std::span<AnyColumn* const> columns) { links_.begin(comm_, columns); }
void MpiBondHalo::finish(Solids&) { links_.finish(comm_); }

}  // namespace thaw
