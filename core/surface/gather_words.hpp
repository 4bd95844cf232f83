// Lists of all ranks, known to all.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"

namespace thaw {

/// The words of all ranks, one rank behind another. For lists that are short in all (a few words a
/// component). Collective.
std::vector<std::uint64_t> gatherWords(Reducer& all, const std::vector<std::uint64_t>& mine);

/// Words of all ranks numbered through, one rank behind another.
struct WordNumbers {
  std::size_t before = 0, total = 0;
};  ///< number of this rank's first one; of all
WordNumbers numberWords(Reducer& all, std::size_t mine);

/// Those numbered from `from` up to `to`, for lists that are gone through in pieces: no rank ever holds more
/// than one. Collective.
std::vector<std::uint64_t> gatherPiece(Reducer& all, const std::vector<std::uint64_t>& mine,
                                       const WordNumbers& numbers, std::size_t from, std::size_t to);

}  // namespace thaw
