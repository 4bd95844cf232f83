// SPDX-License-Identifier: Apache-2.0
// All-gather of 64-bit words.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"

namespace thaw {

/// Returns the words of all ranks in rank order. Use it only for lists that are short in total (a few words
/// per component). Collective.
std::vector<std::uint64_t> gatherWords(Reducer& all, const std::vector<std::uint64_t>& mine);

/// Number of words on lower ranks, and on all ranks.
struct WordNumbers {
  std::size_t before = 0, total = 0;
};
WordNumbers numberWords(Reducer& all, std::size_t mine);

/// Returns words `from` to `to` (exclusive) of all ranks. Long lists are gathered in chunks to bound memory.
/// Collective.
std::vector<std::uint64_t> gatherChunk(Reducer& all, const std::vector<std::uint64_t>& mine,
                                       const WordNumbers& numbers, std::size_t from, std::size_t to);

}  // namespace thaw
