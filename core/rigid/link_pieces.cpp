// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/link_pieces.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

/// A piece that this rank needs.
struct Need {
  std::uint64_t id = 0;
  std::uint32_t localParticles = 0;  ///< owned particles
  bool border = false;  ///< another rank may need the piece, because it has particles in border cells, or
                        ///< ghosts
};

void sortRows(Pieces& p) {
  if (std::is_sorted(p.id.data(), p.id.data() + p.owned)) return;
  std::vector<std::uint32_t> order(p.owned);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return p.id[a] < p.id[b]; });
  p.reorder(order);
}

/// Returns the pieces of owned particles and ghosts, ascending.
std::vector<Need> findNeeds(const RigidView& v, const CellHalo& cells, PieceUsers users, bool alone) {
  const Continuum& p = v.particles;
  std::unordered_map<std::uint64_t, Need> found;
  Need* last = nullptr;  // entry of the previous row, usually of the same piece
  const auto add = [&](std::size_t i) -> Need& {
    if (!last || last->id != p.piece[i]) last = &found[p.piece[i]];
    last->id = p.piece[i];
    return *last;
  };
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] != notRigid) add(i).localParticles++;
  if (users == PieceUsers::AndGhosts)
    for (std::size_t i = p.owned; i < p.size(); i++)
      if (p.piece[i] != notRigid) add(i).border = true;
  for (std::size_t c = 0; c < v.cells.key.size() && !alone; c++) {
    if (v.cells.first[c] >= p.owned || cells.inner(v.cells.key[c])) continue;
    for (std::size_t i = v.cells.first[c]; i < v.cells.first[c] + v.cells.count[c]; i++)
      if (p.piece[i] != notRigid) add(i).border = true;
  }
  std::vector<Need> needs;
  for (const auto& [id, need] : found) needs.push_back(need);
  std::sort(needs.begin(), needs.end(), [](const Need& a, const Need& b) { return a.id < b.id; });
  return needs;
}

std::size_t rowWords(const Pieces& p) { return (p.stateBytes() + 7) / 8; }

void appendRow(const Pieces& p, std::uint32_t row, std::vector<std::uint64_t>& words) {
  const std::size_t at = words.size();
  words.resize(at + rowWords(p), 0);
  p.packState(row, reinterpret_cast<std::byte*>(words.data() + at));
}

/// Flags of a message about a piece to its home rank, in the word after the id.
constexpr std::uint64_t holds = 1, wants = 2, gives = 4;
constexpr int numberShift = 8;  ///< bits of an answer below the number of a shared piece

/// A piece at its home rank.
struct Entry {
  const std::uint64_t* row = nullptr;
  std::vector<int> holders;
  std::uint64_t number = 0;  ///< number of a shared piece
};

void announce(const RigidView& v, const std::vector<Need>& needs, int ranks, WordStreams& out) {
  const Pieces& p = v.pieces;
  const auto send = [&](std::uint64_t id, std::uint64_t flags) {
    const std::uint32_t row = p.rowOf(id);
    flags |= row != noPieceRow ? gives : wants;
    std::vector<std::uint64_t>& to = out.to(homeRank(id, ranks));
    to.push_back(id);
    to.push_back(flags);
    if (row != noPieceRow) appendRow(p, row, to);
  };
  for (const Need& n : needs) {
    const std::uint32_t row = p.rowOf(n.id);
    if (n.border || row == noPieceRow || p.count[row] != n.localParticles) send(n.id, holds);
  }
  const auto needed = [&](std::uint64_t id) {
    return std::binary_search(needs.begin(), needs.end(), Need{id},
                              [](const Need& a, const Need& b) { return a.id < b.id; });
  };
  std::vector<std::uint64_t>& gone = v.work.departed;
  std::sort(gone.begin(), gone.end());
  gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
  for (const std::uint64_t id : gone)
    if (p.rowOf(id) != noPieceRow && !needed(id)) send(id, 0);
  gone.clear();
}

std::unordered_map<std::uint64_t, Entry> readAnnounced(const std::vector<WordStream>& in, std::size_t width) {
  std::unordered_map<std::uint64_t, Entry> home;
  for (const WordStream& s : in)
    for (std::size_t k = 0; k < s.words.size();) {
      Entry& e = home[s.words[k]];
      const std::uint64_t flags = s.words[k + 1];
      k += 2;
      if (flags & holds) e.holders.push_back(s.rank);
      if (flags & gives) {
        e.row = s.words.data() + k;
        k += width;
      }
    }
  return home;
}

/// Numbers the shared pieces of all ranks, by home rank and then by id. Returns the total number. Collective.
std::size_t numberShared(std::unordered_map<std::uint64_t, Entry>& home, Reducer& all) {
  std::vector<std::uint64_t> mine;
  for (const auto& [id, e] : home)
    if (e.holders.size() > 1) mine.push_back(id);
  std::sort(mine.begin(), mine.end());
  std::vector<std::int64_t> counts(static_cast<std::size_t>(all.size()), 0);
  counts[static_cast<std::size_t>(all.rank())] = static_cast<std::int64_t>(mine.size());
  all.sum(counts);
  std::int64_t first = 0, total = 0;
  for (std::size_t r = 0; r < counts.size(); r++) {
    if (static_cast<int>(r) < all.rank()) first += counts[r];
    total += counts[r];
  }
  for (std::size_t k = 0; k < mine.size(); k++)
    home.at(mine[k]).number = static_cast<std::uint64_t>(first) + k;
  return static_cast<std::size_t>(total);
}

/// Returns the replies to each holder: the number of the piece if other ranks hold it, and its row if
/// requested.
WordStreams answers(const std::vector<WordStream>& in, const std::unordered_map<std::uint64_t, Entry>& home,
                    std::size_t width, int ranks) {
  WordStreams out(ranks);
  for (const WordStream& s : in)
    for (std::size_t k = 0; k < s.words.size();) {
      const std::uint64_t id = s.words[k], flags = s.words[k + 1];
      k += 2 + (flags & gives ? width : 0);
      if (!(flags & holds)) continue;
      const Entry& e = home.at(id);
      std::vector<std::uint64_t>& to = out.to(s.rank);
      to.push_back(id);
      to.push_back((e.holders.size() > 1 ? holds | e.number << numberShift : 0) | (flags & wants));
      if (!(flags & wants)) continue;
      if (!e.row) throw std::logic_error("no rank has the row of a rigid piece");
      to.insert(to.end(), e.row, e.row + width);
    }
  return out;
}

using SharedNumbers = std::unordered_map<std::uint64_t, std::uint32_t>;

/// Adds received rows, and the numbers of needed pieces that other ranks hold.
void takeAnswers(const std::vector<WordStream>& in, Pieces& p, SharedNumbers& shared) {
  const std::size_t width = rowWords(p);
  for (const WordStream& s : in)
    for (std::size_t k = 0; k < s.words.size();) {
      const std::uint64_t id = s.words[k], flags = s.words[k + 1];
      k += 2;
      if (flags & holds) shared[id] = static_cast<std::uint32_t>(flags >> numberShift);
      if (!(flags & wants)) continue;
      p.resize(p.owned + 1, 0);
      p.unpackState(p.owned - 1, reinterpret_cast<const std::byte*>(s.words.data() + k));
      k += width;
    }
}

void setRows(Continuum& p, const Pieces& pieces, PieceUsers users) {
  std::uint64_t last = notRigid;
  std::uint32_t row = noPieceRow;
  const std::size_t end = users == PieceUsers::AndGhosts ? p.size() : p.owned;
  for (std::size_t i = 0; i < end; i++) {
    if (p.piece[i] != last) {
      last = p.piece[i];
      row = last == notRigid ? noPieceRow : pieces.rowOf(last);
    }
    p.pieceRow[i] = row;
  }
}

}  // namespace

void linkPieces(const RigidView& v, const Halos& halos, PieceUsers users) {
  Pieces& p = v.pieces;
  Continuum& c = v.particles;
  Reducer& all = halos.all;
  sortRows(p);
  const std::vector<Need> needs = findNeeds(v, halos.cells, users, all.size() == 1);
  SharedNumbers shared;
  SharedPieces& numbers = v.work.shared;
  numbers.total = 0;
  if (all.size() > 1) {
    WordStreams out(all.size());
    announce(v, needs, all.size(), out);
    const std::vector<WordStream> in = all.sparseAllToAll(std::move(out.lists));
    const std::size_t width = rowWords(p);
    std::unordered_map<std::uint64_t, Entry> home = readAnnounced(in, width);
    numbers.total = numberShared(home, all);
    WordStreams back = answers(in, home, width, all.size());
    takeAnswers(all.sparseAllToAll(std::move(back.lists)), p, shared);
    sortRows(p);
  }
  v.work.departed.clear();
  std::vector<std::uint32_t> kept;
  for (const Need& n : needs) {
    const std::uint32_t row = p.rowOf(n.id);
    if (row == noPieceRow) throw std::logic_error("a rigid piece has no row");
    kept.push_back(row);
  }
  p.reorder(kept);
  numbers.number.assign(needs.size(), SharedPieces::notShared);
  for (std::size_t k = 0; k < needs.size(); k++) {
    p.localParticles[k] = needs[k].localParticles;
    const auto at = shared.find(needs[k].id);
    p.shared[k] = at != shared.end();
    if (at != shared.end()) numbers.number[k] = at->second;
    p.recordsEnergy[k] = 0;
  }
  setRows(c, p, users);
  for (std::size_t i = 0; i < c.owned; i++)
    if (c.piece[i] == c.id[i] + 1) p.recordsEnergy[c.pieceRow[i]] = 1;
}

void copyLedRows(const Pieces& from, Pieces& to) {
  to.resize(0, 0);
  if (!from.id.active) return;
  activatePieces(to);
  std::vector<std::byte> row(from.stateBytes());
  for (std::size_t k = 0; k < from.owned; k++) {
    if (!from.recordsEnergy[k]) continue;
    to.resize(to.owned + 1, 0);
    from.packState(k, row.data());
    to.unpackState(to.owned - 1, row.data());
    to.recordsEnergy[to.owned - 1] = 1;
  }
}

}  // namespace thaw
