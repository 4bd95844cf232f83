// SPDX-License-Identifier: Apache-2.0
// Sums and minima over all ranks that hold a piece.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace thaw {

/// Returns the rank that combines the data of a piece from all ranks.
inline int homeRank(std::uint64_t piece, int ranks) {
  std::uint64_t h = piece * 0x9e3779b97f4a7c15u;
  h ^= h >> 32;
  return static_cast<int>(h % static_cast<std::uint64_t>(ranks));
}

class PieceExchange {
 public:
  virtual ~PieceExchange() = default;

  /// Replaces words [row * perPiece, (row + 1) * perPiece) of each row by their sums, element by element. The
  /// sum is over all ranks that hold the piece, and is the same on each of them. Words are signed and must
  /// not overflow. Rows that only this rank holds do not change. Collective: every rank makes the same
  /// number of calls, with any number of rows.
  virtual void sum(std::span<std::int64_t> words, std::size_t perPiece) = 0;

  /// Replaces the word of each row by its minimum over all ranks that hold the piece. Collective.
  virtual void minimum(std::span<std::uint64_t> words) = 0;

  /// Returns the id of a row, the same on all ranks that hold it.
  virtual std::uint64_t id(std::size_t row) const = 0;

  /// Returns true if other ranks may hold the row. The result is the same on all ranks that hold it.
  virtual bool shared(std::size_t row) const = 0;
};

/// The exchange of a single process.
class SerialPieceExchange : public PieceExchange {
 public:
  void sum(std::span<std::int64_t>, std::size_t) override {}
  void minimum(std::span<std::uint64_t>) override {}
  std::uint64_t id(std::size_t row) const override { return row; }
  bool shared(std::size_t) const override { return false; }
};

}  // namespace thaw
