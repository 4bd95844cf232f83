// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/contact_islands.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "core/halo/spread_labels.hpp"
#include "core/halo/word_streams.hpp"

namespace thaw {
namespace {

constexpr std::uint64_t noIsland = ~std::uint64_t{0};

bool movable(const PieceMotion& m) { return m.inverseMass > 0; }

/// Islands of the rows of this rank.
struct RowLabels {
  std::vector<std::uint64_t> label;  ///< 1 + the smallest id of the rows of the island on all ranks;
                                     ///< noIsland: none
  std::vector<std::uint8_t> shared;  ///< 1: other ranks also have rows of the island
};

RowLabels labelRows(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                    PieceExchange& exchange, Reducer& all) {
  RowLabels rows{std::vector<std::uint64_t>(pieces.size(), noIsland),
                 std::vector<std::uint8_t>(pieces.size(), 0)};
  DisjointSets sets(pieces.size());
  const auto touch = [&](std::uint32_t r) {
    if (r != noPiece && movable(pieces[r])) rows.label[r] = exchange.id(r) + 1;
  };
  for (const RigidContact& c : contacts) {
    touch(c.a);
    touch(c.b);
    if (c.b != noPiece && movable(pieces[c.a]) && movable(pieces[c.b])) sets.join(c.a, c.b);
  }
  const auto share = [&] { exchange.minimum(rows.label); };
  share();  // other ranks may have the contacts of a row
  spreadLabels(rows.label, rows.label.size(), sets, all, share);
  for (std::uint32_t r = 0; r < pieces.size(); r++)
    if (movable(pieces[r]) && exchange.shared(r)) rows.shared[sets.find(r)] = 1;
  for (std::uint32_t r = 0; r < pieces.size(); r++) rows.shared[r] = rows.shared[sets.find(r)];
  return rows;
}

/// Rows and contacts of an island on this rank.
struct Members {
  int home = 0;
  std::vector<std::uint32_t> rows, contacts;
};

std::map<std::uint64_t, Members> membersOf(std::span<const PieceMotion> pieces,
                                           std::span<const RigidContact> contacts, const RowLabels& rows,
                                           const Reducer& all) {
  std::map<std::uint64_t, Members> members;
  const auto membersWith = [&](std::uint32_t r) -> Members& {
    Members& m = members[rows.label[r]];
    m.home = rows.shared[r] ? homeRank(rows.label[r], all.size()) : all.rank();
    return m;
  };
  for (std::uint32_t r = 0; r < pieces.size(); r++)
    if (rows.label[r] != noIsland) membersWith(r).rows.push_back(r);
  for (std::uint32_t i = 0; i < contacts.size(); i++) {
    const RigidContact& c = contacts[i];
    if (movable(pieces[c.a])) membersWith(c.a).contacts.push_back(i);
    else if (c.b != noPiece && movable(pieces[c.b])) membersWith(c.b).contacts.push_back(i);
  }
  for (auto& [label, m] : members) {
    for (const std::uint32_t i : m.contacts)
      for (const std::uint32_t r : {contacts[i].a, contacts[i].b})
        if (r != noPiece && !movable(pieces[r])) m.rows.push_back(r);
    std::sort(m.rows.begin(), m.rows.end());
    m.rows.erase(std::unique(m.rows.begin(), m.rows.end()), m.rows.end());
  }
  return members;
}

/// Appends a part of an island: label, numbers of rows and contacts, rows and contacts.
void writePart(std::uint64_t label, const Members& m, std::span<const PieceMotion> pieces,
               std::span<const RigidContact> contacts, const PieceExchange& exchange,
               std::vector<std::uint64_t>& words) {
  words.insert(words.end(), {label, m.rows.size(), m.contacts.size()});
  for (const std::uint32_t r : m.rows) {
    words.push_back(exchange.id(r));
    addWords(words, pieces[r]);
  }
  const auto placeOf = [&](std::uint32_t r) {
    return static_cast<std::uint32_t>(std::lower_bound(m.rows.begin(), m.rows.end(), r) - m.rows.begin());
  };
  for (const std::uint32_t i : m.contacts) {
    RigidContact c = contacts[i];
    c.a = placeOf(c.a);
    if (c.b != noPiece) c.b = placeOf(c.b);
    addWords(words, c);
  }
}

/// Adds a received part to its island. Rows of contacts are indices into `pieces` of the island before
/// sorting.
void readPart(const std::vector<std::uint64_t>& words, std::size_t& at, ContactIsland& island,
              GatheredIslands::Part& part) {
  const std::size_t rows = words[at + 1], contacts = words[at + 2];
  at += 3;
  const auto first = static_cast<std::uint32_t>(island.ids.size());
  for (std::size_t k = 0; k < rows; k++) {
    part.rows.push_back(first + static_cast<std::uint32_t>(k));
    island.ids.push_back(words[at++]);
    island.pieces.push_back(takeWords<PieceMotion>(words, at));
  }
  for (std::size_t k = 0; k < contacts; k++) {
    part.contacts.push_back(static_cast<std::uint32_t>(island.contacts.size()));
    island.contacts.push_back(takeWords<RigidContact>(words, at));
    RigidContact& c = island.contacts.back();
    c.a += first;
    if (c.b != noPiece) c.b += first;
  }
}

/// Indices of rows and contacts in the sorted island.
struct SortedPlaces {
  std::vector<std::uint32_t> row, contact;
};

/// Sorts rows by id, and merges equal rows of several parts.
void sortRows(ContactIsland& s, std::vector<std::uint32_t>& place) {
  std::vector<std::uint64_t> ids = s.ids;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<PieceMotion> pieces(ids.size());
  for (std::size_t k = 0; k < s.ids.size(); k++) {
    place.push_back(
        static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), s.ids[k]) - ids.begin()));
    pieces[place[k]] = s.pieces[k];
  }
  s.ids = std::move(ids);
  s.pieces = std::move(pieces);
}

/// Sorts contacts by their particles. A particle may have several contacts with an obstacle, or with faces
/// and edges of another particle. These are sorted by normals, gaps and points.
void sortContacts(ContactIsland& s, std::vector<std::uint32_t>& place) {
  std::vector<std::uint32_t> order(s.contacts.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const RigidContact& c = s.contacts[i];
    return std::tuple(c.keyA, c.keyB, c.normal.x, c.normal.y, c.normal.z, c.gap, c.armA.x, c.armA.y,
                      c.armA.z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  std::vector<RigidContact> contacts;
  contacts.reserve(order.size());
  place.resize(order.size());
  for (std::size_t k = 0; k < order.size(); k++) {
    place[order[k]] = static_cast<std::uint32_t>(k);
    contacts.push_back(s.contacts[order[k]]);
  }
  s.contacts = std::move(contacts);
}

SortedPlaces sortIsland(ContactIsland& s) {
  SortedPlaces places;
  sortRows(s, places.row);
  for (RigidContact& c : s.contacts) {
    c.a = places.row[c.a];
    if (c.b != noPiece) c.b = places.row[c.b];
  }
  sortContacts(s, places.contact);
  s.changes.resize(s.pieces.size());
  return places;
}

GatheredIslands readIslands(const std::vector<WordStream>& in) {
  GatheredIslands g;
  std::map<std::uint64_t, std::uint32_t> islandOf;
  for (const WordStream& s : in)
    for (std::size_t at = 0; at < s.words.size();) {
      const auto [found, made] = islandOf.try_emplace(s.words[at],
                                                      static_cast<std::uint32_t>(g.islands.size()));
      if (made) g.islands.emplace_back();
      g.parts.push_back({s.rank, found->second, {}, {}});
      readPart(s.words, at, g.islands[found->second], g.parts.back());
    }
  std::vector<SortedPlaces> places;
  for (ContactIsland& island : g.islands) places.push_back(sortIsland(island));
  for (GatheredIslands::Part& part : g.parts) {
    for (std::uint32_t& r : part.rows) r = places[part.island].row[r];
    for (std::uint32_t& i : part.contacts) i = places[part.island].contact[i];
  }
  return g;
}

/// Sends lists to their ranks, and returns the received ones. Collective.
std::vector<WordStream> send(WordStreams out, Reducer& all) {
  return all.size() > 1 ? all.sparseAllToAll(std::move(out.lists)) : std::move(out.lists);
}

}  // namespace

GatheredIslands gatherIslands(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                              PieceExchange& exchange, Reducer& all) {
  const RowLabels rows = labelRows(pieces, contacts, exchange, all);
  WordStreams out(all.size());
  std::vector<GatheredIslands::Sent> sent(static_cast<std::size_t>(all.size()));
  for (const auto& [label, m] : membersOf(pieces, contacts, rows, all)) {
    writePart(label, m, pieces, contacts, exchange, out.to(m.home));
    GatheredIslands::Sent& to = sent[static_cast<std::size_t>(m.home)];
    to.rows.insert(to.rows.end(), m.rows.begin(), m.rows.end());
    to.contacts.insert(to.contacts.end(), m.contacts.begin(), m.contacts.end());
  }
  GatheredIslands g = readIslands(send(std::move(out), all));
  g.sent = std::move(sent);
  return g;
}

void returnIslands(const GatheredIslands& g, std::span<PieceMotion> pieces, std::span<RigidContact> contacts,
                   std::span<PieceChange> changes, Reducer& all) {
  WordStreams back(all.size());
  for (const GatheredIslands::Part& part : g.parts)
    for (const std::uint32_t r : part.rows) {
      const ContactIsland& s = g.islands[part.island];
      std::vector<std::uint64_t>& to = back.to(part.rank);
      addWords(to, s.changes[r]);
      addWords(to, s.pieces[r].velocity);
      addWords(to, s.pieces[r].spin);
    }
  for (const GatheredIslands::Part& part : g.parts)
    for (const std::uint32_t i : part.contacts) {
      const RigidContact& c = g.islands[part.island].contacts[i];
      addWords(back.to(part.rank), c.impulse);
      addWords(back.to(part.rank), c.angularImpulse);
    }
  for (const WordStream& list : send(std::move(back), all)) {
    const GatheredIslands::Sent& sent = g.sent[static_cast<std::size_t>(list.rank)];
    std::size_t at = 0;
    for (const std::uint32_t r : sent.rows) {
      const auto change = takeWords<PieceChange>(list.words, at);
      const auto velocity = takeWords<Vec3d>(list.words, at), spin = takeWords<Vec3d>(list.words, at);
      if (!movable(pieces[r])) continue;  // prescribed rows may be in several islands
      changes[r] = change;
      pieces[r].velocity = velocity;
      pieces[r].spin = spin;
    }
    for (const std::uint32_t i : sent.contacts) {
      contacts[i].impulse = takeWords<Vec3d>(list.words, at);
      contacts[i].angularImpulse = takeWords<Vec3d>(list.words, at);
    }
  }
}

}  // namespace thaw
