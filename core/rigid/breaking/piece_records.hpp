// SPDX-License-Identifier: Apache-2.0
// Exchange of records about pieces, from any rank to all ranks that hold the piece.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"

namespace thaw {

/// Records with a fixed number of words. The first word is the id of the piece.
struct PieceRecords {
  std::size_t width = 1;
  std::vector<std::uint64_t> words;
  std::size_t size() const { return words.size() / width; }
  const std::uint64_t* at(std::size_t k) const { return words.data() + k * width; }
  double number(std::size_t k, std::size_t word) const { return numberAt(words, k * width + word); }
  Vec3d place(std::size_t k, std::size_t word) const { return placeAt(words, k * width + word); }
};

/// Returns the records of all ranks about the pieces that this rank holds, sorted by their words. The home
/// ranks of the pieces forward the records. ownPieces: pieces of this rank. Collective.
PieceRecords shareRecords(const PieceRecords& own, std::span<const std::uint64_t> ownPieces, Reducer& all);

}  // namespace thaw
