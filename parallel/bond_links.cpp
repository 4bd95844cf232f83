// SPDX-License-Identifier: Apache-2.0
#include "parallel/bond_links.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "parallel/cell_halo.hpp"
#include "parallel/solid_directory.hpp"
#include "parallel/transfer.hpp"

namespace thaw {

namespace {

enum Tag { BondTag = 31, LinkKind = 44 };

struct Bytes24 {
  std::uint64_t word[3];
};
struct Bytes64 {
  std::uint64_t word[8];
};
struct Bytes128 {
  std::uint64_t word[16];
};

template<class T, class Links> std::byte* gather(const AnyColumn& c, const Links& links, std::byte* to) {
  const T* from = reinterpret_cast<const T*>(c.bytes.data());
  for (const auto& l : links) {
    std::memcpy(to, from + l.row, sizeof(T));
    to += sizeof(T);
  }
  return to;
}
template<class Links> std::byte* gather(const AnyColumn& c, const Links& links, std::byte* to) {
  switch (c.elementBytes) {
    case 8: return gather<std::uint64_t>(c, links, to);
    case 24: return gather<Bytes24>(c, links, to);
    case 64: return gather<Bytes64>(c, links, to);
    case 128: return gather<Bytes128>(c, links, to);
    default: break;
  }
  for (const auto& l : links) {
    std::memcpy(to, c.bytes.data() + l.row * c.elementBytes, c.elementBytes);
    to += c.elementBytes;
  }
  return to;
}
template<class Links> const std::byte* scatter(AnyColumn& c, const Links& links, const std::byte* from) {
  for (const auto& l : links) {
    std::memcpy(c.bytes.data() + l.row * c.elementBytes, from, c.elementBytes);
    from += c.elementBytes;
  }
  return from;
}

}  // namespace

BondLinks::Partner& BondLinks::partner(int rank) {
  const auto at = std::lower_bound(partners_.begin(), partners_.end(), rank,
                                   [](const Partner& p, int r) { return p.rank < r; });
  if (at != partners_.end() && at->rank == rank) return *at;
  Partner fresh;
  fresh.rank = rank;
  return *partners_.insert(at, std::move(fresh));
}

bool BondLinks::holds(const std::vector<Link>& links, std::uint64_t id) {
  const auto at = std::lower_bound(links.begin(), links.end(), id,
                                   [](const Link& l, std::uint64_t i) { return l.id < i; });
  return at != links.end() && at->id == id;
}

void BondLinks::add(std::vector<Link>& links, std::vector<Link>& more) {
  const auto before = [](const Link& a, const Link& b) { return a.id < b.id; };
  std::sort(more.begin(), more.end(), before);
  const auto middle = static_cast<std::ptrdiff_t>(links.size());
  links.insert(links.end(), more.begin(), more.end());
  std::inplace_merge(links.begin(), links.begin() + middle, links.end(), before);
}

void BondLinks::announceDepartures(const BondGraph& graph, int rank, WordMessages& out) const {
  for (const Partner& p : partners_)
    for (const Link& l : p.sends) {
      const int owner = graph.ownerOf(l.row);
      if (owner == rank) continue;
      std::vector<std::uint64_t>& w = out.to(p.rank);
      w.push_back(l.id);
      w.push_back(static_cast<std::uint64_t>(owner));
    }
}

void BondLinks::announceRemovals(const BondGraph& graph, std::span<const std::uint32_t> solidIndices,
                                 WordMessages& out) const {
  for (const std::uint32_t s : solidIndices)
    for (const Partner& p : partners_) {
      if (!holds(p.sends, graph.idOf(s))) continue;
      std::vector<std::uint64_t>& w = out.to(p.rank);
      w.push_back(graph.idOf(s));
      w.push_back(SolidDirectory::noOwner);
    }
}

void BondLinks::renew(const Communicator& comm, const BondGraph& graph) {
  // Words to each rank: number of released ids, these ids, then the subscribed ids.
  struct Change {
    std::vector<std::uint64_t> giveUp, ask;
    std::vector<Link> rows;
  };
  std::vector<std::pair<int, Change>> changes;
  const auto change = [&](int rank) -> Change& {
    const auto at = std::find_if(changes.begin(), changes.end(),
                                 [&](const auto& c) { return c.first == rank; });
    return at != changes.end() ? at->second : changes.emplace_back(rank, Change{}).second;
  };
  for (const BondGraph::Released& r : graph.released())
    // If the old owner sends no such row, the particle has moved. Its new owner then has no link to this
    // rank.
    if (holds(partner(r.owner).receives, r.id)) change(r.owner).giveUp.push_back(r.id);
  const auto want = [&](std::uint32_t row) {
    Change& c = change(graph.ownerOf(row));
    c.ask.push_back(graph.idOf(row));
    c.rows.push_back({graph.idOf(row), row});
  };
  for (Partner& p : partners_) {
    std::size_t kept = 0;
    for (Link& l : p.sends) {
      const std::uint32_t now = graph.now(l.row);
      if (now != noRow && !graph.isRemote(now)) p.sends[kept++] = {l.id, now};
    }
    p.sends.resize(kept);
    kept = 0;
    for (Link& l : p.receives) {
      const std::uint32_t now = graph.now(l.row);
      if (!graph.isRemote(now)) continue;
      if (graph.ownerOf(now) == p.rank) p.receives[kept++] = {l.id, now};
      else want(now);
    }
    p.receives.resize(kept);
  }
  for (const std::uint32_t row : graph.newRemoteRows()) want(row);

  std::vector<Message> out;
  for (auto& [rank, c] : changes) {
    std::vector<std::uint64_t> words{c.giveUp.size()};
    words.insert(words.end(), c.giveUp.begin(), c.giveUp.end());
    words.insert(words.end(), c.ask.begin(), c.ask.end());
    out.push_back({rank, std::vector<std::byte>(words.size() * sizeof(std::uint64_t))});
    std::memcpy(out.back().bytes.data(), words.data(), out.back().bytes.size());
    add(partner(rank).receives, c.rows);
  }
  std::vector<Link> fresh;
  for (const Message& m : sparseExchange(comm, out, LinkKind, MessagesFor::BondEdits)) {
    std::vector<std::uint64_t> w = wordsOf(m);
    Partner& p = partner(m.rank);
    const auto first = w.begin() + 1, ask = first + static_cast<std::ptrdiff_t>(w[0]);
    std::sort(first, ask);
    std::erase_if(p.sends, [&](const Link& l) { return std::binary_search(first, ask, l.id); });
    fresh.clear();
    for (auto id = ask; id != w.end(); ++id) {
      const std::uint32_t solidIndex = graph.rowOf(*id);
      if (solidIndex == noRow || graph.isRemote(solidIndex))
        throw std::logic_error("another rank requested a solid particle that this rank does not own");
      fresh.push_back({*id, solidIndex});
    }
    add(p.sends, fresh);
  }
  std::erase_if(partners_, [](const Partner& p) { return p.sends.empty() && p.receives.empty(); });
}

void BondLinks::begin(const Communicator& comm, std::span<AnyColumn* const> columns) {
  mark_.begin(comm, MessagesFor::Bonds);
  columns_.clear();
  std::size_t bytes = 0;
  for (AnyColumn* c : columns) {
    if (!c->active) continue;
    columns_.push_back(c);
    bytes += c->elementBytes;
  }
  for (Partner& p : partners_) {
    if (p.receives.empty()) continue;
    p.in.resize(p.receives.size() * bytes);
    startReceive(comm, p.in, {p.rank, BondTag}, p.receiving);
  }
  for (Partner& p : partners_) {
    if (p.sends.empty()) continue;
    p.out.resize(p.sends.size() * bytes);
    std::byte* to = p.out.data();
    for (const AnyColumn* c : columns_) to = gather(*c, p.sends, to);
    startSend(comm, p.out, {p.rank, BondTag}, MessagesFor::Bonds, p.sending);
  }
}

void BondLinks::finish(const Communicator& comm) {
  for (Partner& p : partners_) {
    if (!p.receiving.empty()) {
      const WaitMark waiting(comm, MessagesFor::Bonds);
      finishAll(p.receiving);
    }
    const std::byte* from = p.in.data();
    for (AnyColumn* c : columns_) from = scatter(*c, p.receives, from);
  }
  const WaitMark waiting(comm, MessagesFor::Bonds);
  for (Partner& p : partners_) finishAll(p.sending);
  mark_.end(comm, MessagesFor::Bonds);
}

}  // namespace thaw
