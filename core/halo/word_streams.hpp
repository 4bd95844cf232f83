// SPDX-License-Identifier: Apache-2.0
// Lists of 64-bit words between arbitrary ranks, for exchanges that depend on positions and not on
// neighbouring ranks.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
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

/// Appends an object whose size is a whole number of words.
template<class T> void addWords(std::vector<std::uint64_t>& words, const T& x) {
  static_assert(sizeof(T) % sizeof(std::uint64_t) == 0);
  const auto bits = std::bit_cast<std::array<std::uint64_t, sizeof(T) / sizeof(std::uint64_t)>>(x);
  words.insert(words.end(), bits.begin(), bits.end());
}
/// Returns the object that begins at a word, and moves to the next one.
template<class T> T takeWords(const std::vector<std::uint64_t>& words, std::size_t& at) {
  std::array<std::uint64_t, sizeof(T) / sizeof(std::uint64_t)> bits;
  std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(at), bits.size(), bits.begin());
  at += bits.size();
  return std::bit_cast<T>(bits);
}

}  // namespace thaw
