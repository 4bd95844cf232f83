// SPDX-License-Identifier: Apache-2.0
// Migration of solids with their bonds.
#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "parallel/bond_halo.hpp"

namespace thaw {

void MpiBondHalo::listPendingRecords(const Solids& s) {
  found_.clear();
  SolidRecordView view;
  for (std::size_t w = 0; w < pendingRecords_.size(); w++) {
    std::size_t owner = 0;
    for (std::size_t at = 0; at < pendingRecords_[w].records.size();) {
      const std::size_t end = readRecord(s, pendingRecords_[w].records, at, view);
      found_.push_back({view.id, w, at, end, owner});
      owner += view.bonds.size();
      at = end;
    }
    if (!pendingRecords_[w].adopted && owner != pendingRecords_[w].owners.size())
      throw std::runtime_error("the numbers of bonds and of owners in records of solid particles differ");
  }
  std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) { return a.id < b.id; });
}

const MpiBondHalo::Found* MpiBondHalo::findPendingRecord(std::uint64_t id) const {
  const auto at = std::lower_bound(found_.begin(), found_.end(), id,
                                   [](const Found& f, std::uint64_t i) { return f.id < i; });
  return at != found_.end() && at->id == id ? &*at : nullptr;
}

void MpiBondHalo::migrate(const BondedRows& p, Solids& s, Bonds& b, const Migration& m) {
  if (!p.active) return;
  if (moved_) throw std::logic_error("solid particles migrate twice without a rebuild of bonds in between");
  for (std::size_t i = p.owned - m.arrivals; i < p.owned; i++) {
    p.solidIndex[i] = noSolid;
    solidArrived_ = solidArrived_ || !p.unbonded(i);  // it may have frozen before it migrated, which no rank
                                                      // checks otherwise
  }
  if (comm_.size() == 1) return;
  int any = 0;
  for (std::size_t k = 0; k < m.departed.size(); k++) {
    if (m.departedTo[k] < 0) continue;        // left the domain: rebuildBonds detects it
    if (p.unbonded(m.departed[k])) continue;  // melted before it migrated: rebuildBonds detects it
    const std::uint32_t solidIndex = p.solidIndex[m.departed[k]];
    if (solidIndex != noSolid) departures_.push_back({solidIndex, m.departedTo[k]});
    else any = any || !pendingRecords_.empty();
  }
  any = any || !departures_.empty();
  any = anyRank(any);
  if (!any) return;
  moved_ = true;
  sendDepartures();
  sendRecords(p, s, b, m);
}

// Sends the new owner to ranks with copies and to the directory. This comes before the records, so that
// records contain the final owners of the other ends of bonds.
void MpiBondHalo::sendDepartures() {
  for (const Departure& d : departures_) graph_.setOwner(d.solidIndex, d.to);
  WordMessages updates;
  for (const Departure& d : departures_) {
    std::vector<std::uint64_t>& w = updates.to(directoryRank(graph_.idOf(d.solidIndex), comm_.size()));
    w.push_back(graph_.idOf(d.solidIndex));
    w.push_back(static_cast<std::uint64_t>(d.to));
  }
  links_.announceDepartures(graph_, comm_.rank(), updates);
  applyUpdates(exchange(updates.messages(), UpdateKind), false);
}

void MpiBondHalo::applyUpdates(const std::vector<Message>& in, bool edit) {
  for (const Message& m : in) {
    const std::vector<std::uint64_t> w = wordsOf(m);
    for (std::size_t k = 0; k + 1 < w.size(); k += 2) {
      const std::uint64_t id = w[k], owner = w[k + 1];
      if (directoryRank(id, comm_.size()) == comm_.rank()) directory_.set(id, owner, m.rank);
      const std::uint32_t row = graph_.rowOf(id);
      if (row == noRow || !graph_.isRemote(row)) continue;
      if (owner == SolidDirectory::noOwner) {
        graph_.removeRemote(row);
      } else if (!edit) {
        graph_.setOwner(row, static_cast<int>(owner));
        movedRows_.push_back(row);
      }
    }
  }
}

void MpiBondHalo::sendRecords(const BondedRows& p, const Solids& s, const Bonds& b, const Migration& m) {
  struct Parcel {
    int to;
    SolidRecords records;
    std::vector<std::int32_t> owners;
    bool adopted;
  };
  std::vector<Parcel> parcels;
  const auto parcelTo = [&](int to, bool adopted) -> Parcel& {
    const auto at = std::find_if(parcels.begin(), parcels.end(),
                                 [&](const Parcel& x) { return x.to == to && x.adopted == adopted; });
    return at != parcels.end() ? *at : parcels.emplace_back(Parcel{to, {}, {}, adopted});
  };
  for (const Departure& d : departures_) {
    Parcel& x = parcelTo(d.to, false);
    appendRecord(s, b, d.solidIndex, x.records);
    for (int k = 0; k < b.capacity; k++)
      if (b.hasBond(d.solidIndex, k)) x.owners.push_back(graph_.ownerOf(b.neighbour[b.at(d.solidIndex, k)]));
  }
  if (!pendingRecords_.empty()) {
    listPendingRecords(s);
    for (std::size_t k = 0; k < m.departed.size(); k++) {
      if (m.departedTo[k] < 0 || p.solidIndex[m.departed[k]] != noSolid) continue;
      const Found* f = findPendingRecord(p.id[m.departed[k]]);
      if (!f) continue;
      std::vector<std::byte>& bytes = parcelTo(m.departedTo[k], true).records.bytes;
      const std::vector<std::byte>& from = pendingRecords_[f->waiting].records;
      bytes.insert(bytes.end(), from.begin() + static_cast<std::ptrdiff_t>(f->at),
                   from.begin() + static_cast<std::ptrdiff_t>(f->end));
    }
  }
  std::vector<Message> out;
  for (const Parcel& x : parcels) {
    const std::uint64_t head[2] = {x.records.bytes.size(), x.adopted};
    std::vector<std::byte> bytes(sizeof head + head[0] + x.owners.size() * sizeof(std::int32_t));
    std::memcpy(bytes.data(), head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, x.records.bytes.data(), head[0]);
    if (!x.owners.empty())
      std::memcpy(bytes.data() + sizeof head + head[0], x.owners.data(),
                  x.owners.size() * sizeof(std::int32_t));
    out.push_back({x.to, std::move(bytes)});
  }
  for (const Message& message : exchange(out, RecordKind)) {
    std::uint64_t head[2];
    std::memcpy(head, message.bytes.data(), sizeof head);
    PendingRecords w;
    w.adopted = head[1] != 0;
    const auto first = message.bytes.begin() + sizeof head,
               last = first + static_cast<std::ptrdiff_t>(head[0]);
    w.records.assign(first, last);
    w.owners.resize(static_cast<std::size_t>(message.bytes.end() - last) / sizeof(std::int32_t));
    if (!w.owners.empty()) std::memcpy(w.owners.data(), &*last, w.owners.size() * sizeof(std::int32_t));
    pendingRecords_.push_back(std::move(w));
  }
}

// Begins the edit of the graph: departures and removals.
void MpiBondHalo::leaveSolids(const Solids& s, const Bonds& b) {
  for (const Departure& d : departures_) graph_.depart(b, d.solidIndex);
  removed_.clear();
  for (std::uint32_t solidIndex = 0; solidIndex < s.owned; solidIndex++)
    if (s.particle[solidIndex] == noParticle && !graph_.leaves(solidIndex)) removed_.push_back(solidIndex);
  for (const std::uint32_t solidIndex : removed_) graph_.remove(b, solidIndex);
}

// Matches particles without a row in Solids with the records that arrived for them.
void MpiBondHalo::matchRecords(const BondedRows& p) {
  std::vector<std::uint8_t> used(found_.size(), 0);
  recordOf_.reserve(withoutIndex_.size());
  fresh_.reserve(withoutIndex_.size());
  for (const std::uint32_t row : withoutIndex_) {
    const Found* f = findPendingRecord(p.id[row]);
    if (f) used[static_cast<std::size_t>(f - found_.data())] = 1;
    recordOf_.push_back(f);
    fresh_.push_back({row, nullptr});
  }
  for (std::size_t k = 0; k < found_.size(); k++)
    if (!used[k] && !pendingRecords_[found_[k].waiting].adopted) meltedArrivals_.push_back(found_[k].id);
}

}  // namespace thaw
