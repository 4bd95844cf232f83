// SPDX-License-Identifier: Apache-2.0
// Sums over all ranks that hold a piece.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace thaw {

class PieceExchange {
 public:
  virtual ~PieceExchange() = default;

  /// Replaces words [row * perPiece, (row + 1) * perPiece) of each row by their sums, element by element. The
  /// sum is over all ranks that hold the piece. Every holder gets the same sums. Words are signed and do not
  /// overflow. Rows that only this rank holds stay as they are. Collective: every rank calls it equally
  /// often, with any number of rows.
  virtual void sum(std::span<std::int64_t> words, std::size_t perPiece) = 0;
};

/// The exchange of a single process.
class SerialPieceExchange : public PieceExchange {
 public:
  void sum(std::span<std::int64_t>, std::size_t) override {}
};

}  // namespace thaw
