// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/breaking/piece_records.hpp"

#include <algorithm>
#include <map>

#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

/// Ranks that hold a piece, and its records, at its home rank.
struct Entry {
  std::vector<int> holders;
  std::vector<std::uint64_t> words;
};

/// Tags of the entries in a message to a home rank: a rank that holds a piece, or a record.
constexpr std::uint64_t isHolder = 0, isRecord = 1;

std::map<std::uint64_t, Entry> entriesAtHome(const std::vector<WordStream>& in, std::size_t width) {
  std::map<std::uint64_t, Entry> home;
  for (const WordStream& s : in)
    for (std::size_t k = 0; k < s.words.size();) {
      const bool record = s.words[k++] == isRecord;
      Entry& e = home[s.words[k]];
      if (!record) {
        e.holders.push_back(s.rank);
        k++;
        continue;
      }
      const auto from = s.words.begin() + static_cast<std::ptrdiff_t>(k);
      e.words.insert(e.words.end(), from, from + static_cast<std::ptrdiff_t>(width));
      k += width;
    }
  return home;
}

void sortRecords(PieceRecords& r) {
  std::vector<std::vector<std::uint64_t>> list;
  for (std::size_t k = 0; k < r.size(); k++) list.emplace_back(r.at(k), r.at(k) + r.width);
  std::sort(list.begin(), list.end());
  r.words.clear();
  for (const auto& record : list) r.words.insert(r.words.end(), record.begin(), record.end());
}

}  // namespace

PieceRecords shareRecords(const PieceRecords& own, std::span<const std::uint64_t> ownPieces, Reducer& all) {
  WordStreams out(all.size());
  for (const std::uint64_t id : ownPieces) {
    std::vector<std::uint64_t>& to = out.to(homeRank(id, all.size()));
    to.insert(to.end(), {isHolder, id});
  }
  for (std::size_t k = 0; k < own.size(); k++) {
    std::vector<std::uint64_t>& to = out.to(homeRank(own.at(k)[0], all.size()));
    to.push_back(isRecord);
    to.insert(to.end(), own.at(k), own.at(k) + own.width);
  }
  WordStreams back(all.size());
  for (const auto& [id, e] : entriesAtHome(all.sparseAllToAll(std::move(out.lists)), own.width))
    for (const int rank : e.holders) {
      if (e.words.empty()) continue;
      std::vector<std::uint64_t>& to = back.to(rank);
      to.insert(to.end(), e.words.begin(), e.words.end());
    }
  PieceRecords shared{own.width, {}};
  for (const WordStream& s : all.sparseAllToAll(std::move(back.lists)))
    shared.words.insert(shared.words.end(), s.words.begin(), s.words.end());
  sortRecords(shared);
  return shared;
}

}  // namespace thaw
