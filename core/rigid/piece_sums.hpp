// SPDX-License-Identifier: Apache-2.0
// Sums over the particles of pieces on several ranks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/math/exact_sum.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/data/pieces.hpp"
#include "core/rigid/data/rigid_work.hpp"

namespace thaw {

/// Adds words of pieces over all ranks that have the pieces. If there are few words, one reduction over all
/// ranks adds them. Many words are added at the home rank of each piece. The sums are the same.
class RankPieceExchange : public PieceExchange {
 public:
  /// ids: piece of each row. shared: null if any row may be shared.
  RankPieceExchange(Reducer& all, std::span<const std::uint64_t> ids, const SharedPieces* shared)
      : all_(all), ids_(ids), shared_(shared) {}
  void sum(std::span<std::int64_t> words, std::size_t perPiece) override;
  void minimum(std::span<std::uint64_t> words) override;
  std::uint64_t id(std::size_t row) const override { return ids_[row]; }
  bool shared(std::size_t row) const override {
    return all_.size() > 1 && (!shared_ || shared_->number[row] != SharedPieces::notShared);
  }

 private:
  void sumDense(std::span<std::int64_t> words, std::size_t perPiece);
  template<class Combine>
  void combineAtHomes(std::span<std::uint64_t> words, std::size_t perPiece, Combine&& combine);
  Reducer& all_;
  std::span<const std::uint64_t> ids_;
  const SharedPieces* shared_;
  std::vector<std::int64_t> dense_;
};

inline RankPieceExchange exchangeOf(const Pieces& p, const RigidWork& work, Reducer& all) {
  return {all, {p.id.data(), p.owned}, &work.shared};
}

/// Returns the pieces of some rows.
inline std::vector<std::uint64_t> idsOf(const Pieces& p, std::span<const std::uint32_t> rows) {
  std::vector<std::uint64_t> ids;
  for (const std::uint32_t k : rows) ids.push_back(p.id[k]);
  return ids;
}

/// Replaces exact sums, perPiece for each row, by the sums over all ranks. words: scratch buffer. Collective.
void sumOverRanks(PieceExchange& exchange, std::span<ExactSum> sums, std::size_t perPiece,
                  std::vector<std::int64_t>& words);

}  // namespace thaw
