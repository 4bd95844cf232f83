// SPDX-License-Identifier: Apache-2.0
// Sums over the particles of pieces that lie on several ranks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/math/exact_sum.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/data/pieces.hpp"

namespace thaw {

/// Returns the rank that adds the sums of a piece.
inline int homeRank(std::uint64_t piece, int ranks) {
  std::uint64_t h = piece * 0x9e3779b97f4a7c15u;
  h ^= h >> 32;
  return static_cast<int>(h % static_cast<std::uint64_t>(ranks));
}

/// Adds words at the home rank of each piece and returns the sums to its holders.
class RankPieceExchange : public PieceExchange {
 public:
  /// ids: piece of each row. shared: rows that further ranks have; empty: any row may be.
  RankPieceExchange(Reducer& all, std::span<const std::uint64_t> ids, std::span<const std::uint8_t> shared)
      : all_(all), ids_(ids), shared_(shared) {}
  void sum(std::span<std::int64_t> words, std::size_t perPiece) override;

 private:
  bool isShared(std::size_t row) const { return shared_.empty() || shared_[row] != 0; }
  Reducer& all_;
  std::span<const std::uint64_t> ids_;
  std::span<const std::uint8_t> shared_;
};

inline RankPieceExchange exchangeOf(const Pieces& p, Reducer& all) {
  return {all, {p.id.data(), p.owned}, {p.shared.data(), p.owned}};
}

/// Replaces exact sums, perPiece for each row, by those of all ranks. words: scratch. Collective.
void sumOverRanks(PieceExchange& exchange, std::span<ExactSum> sums, std::size_t perPiece,
                  std::vector<std::int64_t>& words);

}  // namespace thaw
