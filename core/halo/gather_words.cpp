// SPDX-License-Identifier: Apache-2.0
#include "core/halo/gather_words.hpp"

#include <algorithm>
#include <bit>

namespace thaw {

WordNumbers numberWords(Reducer& all, std::size_t mine) {
  if (all.size() == 1) return {0, mine};
  std::vector<std::int64_t> sizes(static_cast<std::size_t>(all.size()));
  sizes[static_cast<std::size_t>(all.rank())] = static_cast<std::int64_t>(mine);
  all.sum(sizes);
  WordNumbers n;
  for (std::size_t r = 0; r < sizes.size(); r++) {
    if (r < static_cast<std::size_t>(all.rank())) n.before += static_cast<std::size_t>(sizes[r]);
    n.total += static_cast<std::size_t>(sizes[r]);
  }
  return n;
}

std::vector<std::uint64_t> gatherChunk(Reducer& all, const std::vector<std::uint64_t>& mine,
                                       const WordNumbers& n, std::size_t from, std::size_t to) {
  const std::size_t first = std::clamp(n.before, from, to),
                    last = std::clamp(n.before + mine.size(), from, to);
  // Other ranks add zeros to the words of this rank.
  std::vector<std::int64_t> words(to - from);
  for (std::size_t k = first; k < last; k++)
    words[k - from] = std::bit_cast<std::int64_t>(mine[k - n.before]);
  if (!words.empty()) all.sum(words);
  std::vector<std::uint64_t> gathered(words.size());
  for (std::size_t k = 0; k < words.size(); k++) gathered[k] = std::bit_cast<std::uint64_t>(words[k]);
  return gathered;
}

std::vector<std::uint64_t> gatherWords(Reducer& all, const std::vector<std::uint64_t>& mine) {
  if (all.size() == 1) return mine;
  const WordNumbers n = numberWords(all, mine.size());
  return gatherChunk(all, mine, n, 0, n.total);
}

}  // namespace thaw
