// SPDX-License-Identifier: Apache-2.0
// Lists of 64-bit words between arbitrary ranks, for exchanges that follow from positions and not from the
// neighbourhood of ranks.
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// rank: destination or source.
struct WordStream {
  int rank = 0;
  std::vector<std::uint64_t> words;
};

/// One list per destination rank.
struct WordStreams {
  std::vector<WordStream> lists;
  std::vector<int> placeOf;  // index in `lists` per rank; -1: none

  explicit WordStreams(int ranks) : placeOf(static_cast<std::size_t>(ranks), -1) {}
  std::vector<std::uint64_t>& to(int rank) {
    int& at = placeOf[static_cast<std::size_t>(rank)];
    if (at < 0) {
      at = static_cast<int>(lists.size());
      lists.push_back({rank, {}});
    }
    return lists[static_cast<std::size_t>(at)].words;
  }
};

inline void addNumber(std::vector<std::uint64_t>& words, double x) {
  words.push_back(std::bit_cast<std::uint64_t>(x));
}
inline void addPlace(std::vector<std::uint64_t>& words, const Vec3d& x) {
  for (int a = 0; a < 3; a++) addNumber(words, x[a]);
}
inline double numberAt(const std::vector<std::uint64_t>& words, std::size_t k) {
  return std::bit_cast<double>(words[k]);
}
inline Vec3d placeAt(const std::vector<std::uint64_t>& words, std::size_t k) {
  return {numberAt(words, k), numberAt(words, k + 1), numberAt(words, k + 2)};
}

}  // namespace thaw
