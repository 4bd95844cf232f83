// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/piece_sums.hpp"

#include <algorithm>
#include <unordered_map>

namespace thaw {
namespace {

/// Words at the home rank, by piece.
using HomeWords = std::unordered_map<std::uint64_t, std::vector<std::uint64_t>>;

/// Combines all received words of each piece. The order does not matter.
template<class Combine>
HomeWords combineReceived(const std::vector<WordStream>& in, std::size_t perPiece, Combine&& combine) {
  HomeWords home;
  for (const WordStream& s : in)
    for (std::size_t k = 0; k < s.words.size(); k += perPiece + 1) {
      const auto first = s.words.begin() + static_cast<std::ptrdiff_t>(k + 1);
      const auto [at, made] = home.try_emplace(s.words[k], first,
                                               first + static_cast<std::ptrdiff_t>(perPiece));
      for (std::size_t n = 0; n < perPiece && !made; n++)
        at->second[n] = combine(at->second[n], s.words[k + 1 + n]);
    }
  return home;
}

}  // namespace

void RankPieceExchange::sum(std::span<std::int64_t> words, std::size_t perPiece) {
  constexpr std::size_t mostDense = 16384;  // words
  if (all_.size() == 1 || (shared_ && shared_->total == 0)) return;
  if (shared_ && shared_->total * perPiece <= mostDense) sumDense(words, perPiece);
  else
    combineAtHomes({reinterpret_cast<std::uint64_t*>(words.data()), words.size()}, perPiece,
                   [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

void RankPieceExchange::minimum(std::span<std::uint64_t> words) {
  if (all_.size() == 1 || (shared_ && shared_->total == 0)) return;
  combineAtHomes(words, 1, [](std::uint64_t a, std::uint64_t b) { return std::min(a, b); });
}

void RankPieceExchange::sumDense(std::span<std::int64_t> words, std::size_t perPiece) {
  dense_.assign(shared_->total * perPiece, 0);
  const auto eachShared = [&](auto&& use) {
    for (std::size_t row = 0; row < ids_.size(); row++)
      if (shared(row))
        for (std::size_t n = 0; n < perPiece; n++)
          use(words[row * perPiece + n], dense_[shared_->number[row] * perPiece + n]);
  };
  eachShared([](std::int64_t word, std::int64_t& sum) { sum = word; });
  all_.sum(dense_);
  eachShared([](std::int64_t& word, std::int64_t sum) { word = sum; });
}

template<class Combine>
void RankPieceExchange::combineAtHomes(std::span<std::uint64_t> words, std::size_t perPiece,
                                       Combine&& combine) {
  const int ranks = all_.size();
  WordStreams out(ranks);
  std::vector<std::vector<std::uint32_t>> rowsTo(static_cast<std::size_t>(ranks));
  for (std::size_t row = 0; row < ids_.size(); row++) {
    if (!shared(row)) continue;
    const int home = homeRank(ids_[row], ranks);
    std::vector<std::uint64_t>& to = out.to(home);
    to.push_back(ids_[row]);
    for (std::size_t n = 0; n < perPiece; n++) to.push_back(words[row * perPiece + n]);
    rowsTo[static_cast<std::size_t>(home)].push_back(static_cast<std::uint32_t>(row));
  }
  const std::vector<WordStream> in = all_.sparseAllToAll(std::move(out.lists));
  const HomeWords home = combineReceived(in, perPiece, combine);
  WordStreams back(ranks);
  for (const WordStream& s : in) {
    std::vector<std::uint64_t>& to = back.to(s.rank);
    for (std::size_t k = 0; k < s.words.size(); k += perPiece + 1) {
      const std::vector<std::uint64_t>& combined = home.at(s.words[k]);
      to.insert(to.end(), combined.begin(), combined.end());
    }
  }
  for (const WordStream& s : all_.sparseAllToAll(std::move(back.lists))) {
    const std::vector<std::uint32_t>& rows = rowsTo[static_cast<std::size_t>(s.rank)];
    for (std::size_t k = 0; k < rows.size(); k++)
      for (std::size_t n = 0; n < perPiece; n++) words[rows[k] * perPiece + n] = s.words[k * perPiece + n];
  }
}

void sumOverRanks(PieceExchange& exchange, std::span<ExactSum> sums, std::size_t perPiece,
                  std::vector<std::int64_t>& words) {
  constexpr std::size_t digits = ExactSum::digits;
  words.resize(sums.size() * digits);
  for (std::size_t k = 0; k < sums.size(); k++) {
    sums[k].carry();
    std::copy_n(sums[k].digit.begin(), digits, words.begin() + static_cast<std::ptrdiff_t>(k * digits));
  }
  exchange.sum(words, perPiece * digits);
  for (std::size_t k = 0; k < sums.size(); k++)
    std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(k * digits), digits, sums[k].digit.begin());
}

}  // namespace thaw
