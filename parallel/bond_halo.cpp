#include "parallel/bond_halo.hpp"

#include <algorithm>
#include <cstring>

#include "parallel/sparse_exchange.hpp"

namespace thaw {
namespace {

enum Tag { BondTag = 31, RecordKind = 40, UpdateKind = 41, QueryKind = 42, AnswerKind = 43, SubscribeKind = 44 };
constexpr std::uint32_t unset = 0xffffffffu, dropped = 0xfffffffeu;

int directoryRank(std::uint64_t id, int size) {
  std::uint64_t x = id;
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  x ^= x >> 33;
  return static_cast<int>(x % static_cast<std::uint64_t>(size));
}

/// Messages of 64-bit words, one a rank.
struct Words {
  std::vector<std::vector<std::uint64_t>> of;
  explicit Words(int size) : of(static_cast<std::size_t>(size)) {}
  std::vector<Message> messages() const {
    std::vector<Message> m;
    for (std::size_t r = 0; r < of.size(); r++)
      if (!of[r].empty()) {
        m.push_back({static_cast<int>(r), std::vector<std::byte>(of[r].size() * 8)});
        std::memcpy(m.back().bytes.data(), of[r].data(), m.back().bytes.size());
      }
    return m;
  }
};
std::vector<std::uint64_t> wordsOf(const Message& m) {
  std::vector<std::uint64_t> w(m.bytes.size() / 8);
  if (!w.empty()) std::memcpy(w.data(), m.bytes.data(), w.size() * 8);
  return w;
}

void copyBond(Bonds& b, std::size_t from, std::size_t to) {
  b.neighbour[to] = b.neighbour[from];
  b.x[to] = b.x[from];
  b.y[to] = b.y[from];
  b.z[to] = b.z[from];
  b.weight[to] = b.weight[from];
  if (b.twoFrames) b.rx[to] = b.rx[from], b.ry[to] = b.ry[from], b.rz[to] = b.rz[from];
}

void clearBond(Bonds& b, std::size_t slot, int k) {
  const std::size_t at = b.at(slot, k);
  b.neighbour[at] = static_cast<std::uint32_t>(slot);
  b.weight[at] = b.x[at] = b.y[at] = b.z[at] = 0;
  if (b.twoFrames) b.rx[at] = b.ry[at] = b.rz[at] = 0;
}

void clearSlot(Bonds& b, std::size_t slot) {
  for (int k = 0; k < b.capacity; k++) clearBond(b, slot, k);
}

/// Number of places used by a slot's bonds, broken ones between others included.
int lastBond(const Bonds& b, std::size_t slot) {
  int n = b.capacity;
  while (n > 0 && !(b.weight[b.at(slot, n - 1)] > 0)) n--;
  return n;
}

void copyRow(Table& t, std::size_t from, std::size_t to) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memcpy(c->bytes.data() + to * c->elementBytes, c->bytes.data() + from * c->elementBytes, c->elementBytes);
}

void putBond(Bonds& b, std::size_t slot, int k, std::uint32_t neighbour, const BondRecord& r) {
  const std::size_t at = b.at(slot, k);
  b.neighbour[at] = neighbour;
  b.x[at] = r.reference[0], b.y[at] = r.reference[1], b.z[at] = r.reference[2];
  if (b.twoFrames) b.rx[at] = r.reverse[0], b.ry[at] = r.reverse[1], b.rz[at] = r.reverse[2];
  b.weight[at] = r.weight;
}

}  // namespace

void MpiBondHalo::adopt(std::vector<std::byte> records) {
  arrived_.push_back(std::move(records));
  dirty_ = true;
}

void MpiBondHalo::migrate(Continuum& p, Solids& s, Bonds& b, const Migration& m) {
  if (comm_.size() == 1) return;
  std::vector<Message> out;
  fate_.resize(s.owned, Stays);
  for (std::size_t k = 0; k < m.departed.size(); k++) {
    const std::uint32_t slot = p.slot[m.departed[k]];
    if (slot == noSlot) continue;
    const int to = m.departedTo[k];
    auto at = std::find_if(out.begin(), out.end(), [&](const Message& x) { return x.rank == to && x.bytes.size() < (1u << 29); });
    if (at == out.end()) at = out.insert(out.end(), Message{to, {}});
    SolidRecords records{std::move(at->bytes)};
    appendRecord(s, b, slot, records);
    at->bytes = std::move(records.bytes);
    fate_[slot] = Departs;
    dirty_ = true;
  }
  for (std::size_t i = p.owned - m.arrivals; i < p.owned; i++) p.slot[i] = noSlot;
  for (Message& x : sparseExchange(comm_, out, RecordKind)) {
    traffic_.messages++;
    traffic_.bytes += static_cast<std::int64_t>(x.bytes.size());
    adopt(std::move(x.bytes));
  }
}

std::uint32_t MpiBondHalo::remoteRow(std::uint64_t id, std::size_t owned) {
  const auto [at, isNew] = slotOf_.try_emplace(id, static_cast<std::uint32_t>(owned + remote_.size()));
  if (isNew) remote_.push_back(id);
  return at->second;
}

// Slots that go leave holes, which are filled from the end; then one pass over all bonds renumbers their neighbours. Remote rows
// are numbered anew behind the owned ones as they are met.
void MpiBondHalo::removeAndRenumber(Continuum& p, Solids& s, Bonds& b) {
  const std::size_t before = s.owned, all = s.size();
  fate_.resize(before, Stays);
  for (std::size_t slot = 0; slot < before; slot++) {
    if (fate_[slot] == Departs) continue;
    const std::uint32_t row = s.particle[slot];
    if (row >= p.owned || p.slot[row] != slot) fate_[slot] = Vanishes;  // its particle left the domain
    else if (p.phase[row] == Liquid) fate_[slot] = Vanishes, p.slot[row] = noSlot;
  }
  std::vector<std::uint32_t> now(all, unset);
  std::vector<std::uint64_t> id(all);
  std::copy_n(s.id.data(), all, id.data());
  for (std::uint64_t r : remote_) slotOf_.erase(r);
  remote_.clear();
  s.resize(s.owned, 0);
  std::size_t end = before;
  const auto strike = [&](std::size_t slot) {
    slotOf_.erase(id[slot]);
    if (fate_[slot] == Vanishes) {
      now[slot] = dropped;
      gone_.push_back(id[slot]);
    }
  };
  for (std::size_t slot = 0; slot < end; slot++) {
    if (fate_[slot] == Stays) {
      now[slot] = static_cast<std::uint32_t>(slot);
      continue;
    }
    strike(slot);
    while (end > slot + 1 && fate_[end - 1] != Stays) strike(--end);
    if (--end == slot) break;
    now[end] = static_cast<std::uint32_t>(slot);
    copyRow(s, end, slot);
    for (int k = 0; k < b.capacity; k++) {
      copyBond(b, b.at(end, k), b.at(slot, k));
      if (b.neighbour[b.at(slot, k)] == end) b.neighbour[b.at(slot, k)] = static_cast<std::uint32_t>(end);
    }
    p.slot[s.particle[slot]] = static_cast<std::uint32_t>(slot);
    slotOf_[s.id[slot]] = static_cast<std::uint32_t>(slot);
  }
  for (std::size_t slot = end; slot < before; slot++) clearSlot(b, slot);
  s.resize(end, 0);
  fate_.assign(end, Stays);
  for (std::size_t g = 0; g * lanes < end; g++)
    for (int k = 0; k < b.capacity; k++)
      for (std::size_t l = 0; l < lanes && g * lanes + l < end; l++) {
        const std::size_t slot = g * lanes + l, at = b.at(slot, k);
        const std::uint32_t old = b.neighbour[at];
        if (!(b.weight[at] > 0)) {
          b.neighbour[at] = static_cast<std::uint32_t>(slot);
        } else if (now[old] == dropped) {
          clearBond(b, slot, k);
          s.changed[slot] = 1;
        } else {
          if (now[old] == unset) now[old] = remoteRow(id[old], end);
          b.neighbour[at] = now[old];
        }
      }
}

// New slots: particles that arrived with a record, or that have just become solid. Then the requested bonds.
void MpiBondHalo::addSlots(Continuum& p, Solids& s, Bonds& b, std::span<const BondRequest> requests) {
  std::unordered_map<std::uint64_t, SolidRecordView> records;
  for (const std::vector<std::byte>& bytes : arrived_)
    for (std::size_t at = 0; at < bytes.size();) {
      SolidRecordView view;
      at = readRecord(s, bytes, at, view);
      records.emplace(view.id, std::move(view));
    }
  std::vector<std::uint32_t> rows;
  int most = b.capacity;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] == Solid && p.slot[i] == noSlot) {
      rows.push_back(static_cast<std::uint32_t>(i));
      if (const auto r = records.find(p.id[i]); r != records.end()) most = std::max(most, static_cast<int>(r->second.bonds.size()));
    }
  const std::size_t before = s.owned;
  // remote rows lie behind the owned ones: make room between
  const std::uint32_t shift = static_cast<std::uint32_t>(rows.size());
  if (shift > 0 && !remote_.empty()) {
    for (std::size_t k = 0; k < remote_.size(); k++) slotOf_[remote_[k]] += shift;
    for (std::size_t slot = 0; slot < before; slot++)
      for (int k = 0; k < b.capacity; k++) {
        std::uint32_t& n = b.neighbour[b.at(slot, k)];
        if (n >= before) n += shift;
      }
  }
  s.resize(before + rows.size(), 0);
  resizeBonds(b, s.owned, most);
  for (std::size_t k = 0; k < rows.size(); k++) {
    const std::uint32_t slot = static_cast<std::uint32_t>(before + k), row = rows[k];
    if (const auto r = records.find(p.id[row]); r != records.end()) s.unpackState(slot, r->second.state);
    s.id[slot] = p.id[row];
    s.material[slot] = p.material[row];
    s.particle[slot] = row;
    s.changed[slot] = 1;
    p.slot[row] = slot;
    clearSlot(b, slot);
    come_.push_back(p.id[row]);
  }
  // a remote row that is owned now: bonds to it move to the owned slot
  std::vector<std::uint32_t> now(remote_.size());
  std::vector<std::uint64_t> left;
  std::unordered_map<std::uint64_t, std::uint32_t> fresh;
  for (std::size_t k = 0; k < rows.size(); k++) fresh[p.id[rows[k]]] = static_cast<std::uint32_t>(before + k);
  bool any = false;
  for (std::size_t k = 0; k < remote_.size(); k++) {
    if (const auto f = fresh.find(remote_[k]); f != fresh.end()) {
      now[k] = f->second;
      any = true;
    } else {
      now[k] = static_cast<std::uint32_t>(s.owned + left.size());
      left.push_back(remote_[k]);
    }
  }
  if (any) {
    for (std::size_t slot = 0; slot < before; slot++)
      for (int k = 0; k < b.capacity; k++) {
        std::uint32_t& n = b.neighbour[b.at(slot, k)];
        if (n >= s.owned) n = now[n - s.owned];
      }
    remote_ = std::move(left);
    for (std::size_t k = 0; k < remote_.size(); k++) slotOf_[remote_[k]] = static_cast<std::uint32_t>(s.owned + k);
  }
  for (const auto& [id, slot] : fresh) slotOf_[id] = slot;

  for (std::size_t k = 0; k < rows.size(); k++) {
    const auto r = records.find(p.id[rows[k]]);
    if (r == records.end()) continue;
    int n = 0;
    for (const BondRecord& bond : r->second.bonds) putBond(b, before + k, n++, remoteRow(bond.neighbourId, s.owned), bond);
  }
  arrived_.clear();
  for (const BondRequest& q : requests) {
    int n = lastBond(b, q.slot);
    if (n == b.capacity) {  // pack the bonds that are left before making more room
      int kept = 0;
      for (int k = 0; k < n; k++)
        if (b.weight[b.at(q.slot, k)] > 0) copyBond(b, b.at(q.slot, k), b.at(q.slot, kept++));
      for (int k = kept; k < n; k++) clearBond(b, q.slot, k);
      n = kept;
      if (n == b.capacity) {
        const int old = b.capacity;
        resizeBonds(b, s.owned, old + old / 4 + 8);
        for (std::size_t slot = 0; slot < s.owned; slot++)
          for (int k = old; k < b.capacity; k++) clearBond(b, slot, k);
      }
    }
    putBond(b, q.slot, n, remoteRow(q.neighbourId, s.owned),
            {q.neighbourId, {q.reference.x, q.reference.y, q.reference.z}, {q.reverse.x, q.reverse.y, q.reverse.z}, q.weight});
    s.changed[q.slot] = 1;
  }
  fate_.assign(s.owned, Stays);
}

void MpiBondHalo::updateDirectory() {
  if (comm_.size() == 1) {
    gone_.clear();
    come_.clear();
    return;
  }
  Words out(comm_.size());
  for (std::uint64_t id : gone_) {
    std::vector<std::uint64_t>& w = out.of[static_cast<std::size_t>(directoryRank(id, comm_.size()))];
    w.push_back(id);
    w.push_back(0);
  }
  for (std::uint64_t id : come_) {
    std::vector<std::uint64_t>& w = out.of[static_cast<std::size_t>(directoryRank(id, comm_.size()))];
    w.push_back(id);
    w.push_back(1);
  }
  gone_.clear();
  come_.clear();
  for (const Message& m : sparseExchange(comm_, out.messages(), UpdateKind)) {
    const std::vector<std::uint64_t> w = wordsOf(m);
    for (std::size_t k = 0; k + 1 < w.size(); k += 2) {
      if (w[k + 1]) directory_[w[k]] = m.rank;
      else if (const auto at = directory_.find(w[k]); at != directory_.end() && at->second == m.rank) directory_.erase(at);
    }
  }
}

/// Owner of each remote id, -1 where it is not solid any more.
std::vector<int> MpiBondHalo::findOwners() {
  std::vector<int> owner(remote_.size(), -1);
  if (comm_.size() == 1) return owner;
  Words ask(comm_.size());
  std::vector<std::vector<std::uint32_t>> asked(static_cast<std::size_t>(comm_.size()));
  for (std::size_t k = 0; k < remote_.size(); k++) {
    const std::size_t r = static_cast<std::size_t>(directoryRank(remote_[k], comm_.size()));
    ask.of[r].push_back(remote_[k]);
    asked[r].push_back(static_cast<std::uint32_t>(k));
  }
  Words answer(comm_.size());
  for (const Message& m : sparseExchange(comm_, ask.messages(), QueryKind))
    for (std::uint64_t id : wordsOf(m)) {
      const auto at = directory_.find(id);
      answer.of[static_cast<std::size_t>(m.rank)].push_back(at == directory_.end() ? ~0ull : static_cast<std::uint64_t>(at->second));
    }
  for (const Message& m : sparseExchange(comm_, answer.messages(), AnswerKind)) {
    const std::vector<std::uint64_t> w = wordsOf(m);
    for (std::size_t k = 0; k < w.size(); k++)
      if (w[k] != ~0ull) owner[asked[static_cast<std::size_t>(m.rank)][k]] = static_cast<int>(w[k]);
  }
  return owner;
}

void MpiBondHalo::dropBondsTo(const std::vector<int>& owner, Solids& s, Bonds& b) {
  std::vector<std::uint32_t> now(remote_.size(), dropped);
  std::vector<std::uint64_t> kept;
  for (std::size_t k = 0; k < remote_.size(); k++) {
    if (owner[k] >= 0) {
      now[k] = static_cast<std::uint32_t>(s.owned + kept.size());
      slotOf_[remote_[k]] = now[k];
      kept.push_back(remote_[k]);
    } else {
      slotOf_.erase(remote_[k]);
    }
  }
  if (kept.size() == remote_.size()) return;
  remote_ = std::move(kept);
  for (std::size_t slot = 0; slot < s.owned; slot++)
    for (int k = 0; k < b.capacity; k++) {
      const std::size_t at = b.at(slot, k);
      if (b.neighbour[at] < s.owned) continue;
      const std::uint32_t n = now[b.neighbour[at] - s.owned];
      if (n == dropped) {
        clearBond(b, slot, k);
        s.changed[slot] = 1;
      } else {
        b.neighbour[at] = n;
      }
    }
}

void MpiBondHalo::subscribe(const std::vector<int>& owner, const Solids& s) {
  sends_.clear();
  receives_.clear();
  if (comm_.size() == 1) return;
  Words wanted(comm_.size());
  std::vector<std::vector<std::uint32_t>> rows(static_cast<std::size_t>(comm_.size()));
  std::size_t k = 0;
  for (int o : owner) {
    if (o < 0) continue;
    wanted.of[static_cast<std::size_t>(o)].push_back(remote_[k]);
    rows[static_cast<std::size_t>(o)].push_back(static_cast<std::uint32_t>(s.owned + k++));
  }
  for (std::size_t r = 0; r < rows.size(); r++)
    if (!rows[r].empty()) {
      receives_.emplace_back();
      receives_.back().rank = static_cast<int>(r);
      receives_.back().slots = std::move(rows[r]);
    }
  for (const Message& m : sparseExchange(comm_, wanted.messages(), SubscribeKind)) {
    sends_.emplace_back();
    sends_.back().rank = m.rank;
    for (std::uint64_t id : wordsOf(m)) sends_.back().slots.push_back(slotOf_.at(id));
  }
}

bool MpiBondHalo::relink(Continuum& p, Solids& s, Bonds& b, const Relink& work) {
  int changed = dirty_ || work.changedHere || !work.requests.empty();
  if (comm_.size() > 1) MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, comm_.handle());
  if (!changed) return false;
  dirty_ = false;
  linkSlots(p, s);
  // requests name slots of today's numbering: they come after particles have their slots, when removal finds nothing to move
  removeAndRenumber(p, s, b);
  addSlots(p, s, b, work.requests);
  updateDirectory();
  const std::vector<int> owner = findOwners();
  dropBondsTo(owner, s, b);
  subscribe(owner, s);
  s.resize(s.owned, remote_.size());
  for (std::size_t k = 0; k < remote_.size(); k++) {
    s.id[s.owned + k] = remote_[k];
    s.particle[s.owned + k] = noParticle;
  }
  return true;
}

void MpiBondHalo::begin(Solids& s, std::span<AnyColumn* const> columns) {
  columns_.assign(columns.begin(), columns.end());
  std::size_t row = 0;
  for (const AnyColumn* c : columns) row += c->elementBytes;
  for (Partner& r : receives_) {
    r.bytes.resize(r.slots.size() * row);
    MPI_Irecv(r.bytes.data(), static_cast<int>(r.bytes.size()), MPI_BYTE, r.rank, BondTag, comm_.handle(), &r.request);
  }
  for (Partner& t : sends_) {
    t.bytes.resize(t.slots.size() * row);
    std::byte* to = t.bytes.data();
    for (const AnyColumn* c : columns)
      for (std::uint32_t slot : t.slots) {
        std::memcpy(to, c->bytes.data() + slot * c->elementBytes, c->elementBytes);
        to += c->elementBytes;
      }
    MPI_Isend(t.bytes.data(), static_cast<int>(t.bytes.size()), MPI_BYTE, t.rank, BondTag, comm_.handle(), &t.request);
    traffic_.messages++;
    traffic_.bytes += static_cast<std::int64_t>(t.bytes.size());
  }
  (void)s;
}

void MpiBondHalo::finish(Solids&) {
  for (Partner& r : receives_) {
    MPI_Wait(&r.request, MPI_STATUS_IGNORE);
    const std::byte* from = r.bytes.data();
    for (AnyColumn* c : columns_)
      for (std::uint32_t slot : r.slots) {
        std::memcpy(c->bytes.data() + slot * c->elementBytes, from, c->elementBytes);
        from += c->elementBytes;
      }
  }
  for (Partner& t : sends_) MPI_Wait(&t.request, MPI_STATUS_IGNORE);
}

}  // namespace thaw
