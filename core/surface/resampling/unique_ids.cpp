// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/unique_ids.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "core/halo/gather_words.hpp"
#include "core/math/hash_random.hpp"
#include "core/surface/data/surfel_ids.hpp"

namespace thaw {
namespace {

/// Id of a new surfel and its index among those of all ranks.
struct Born {
  std::uint64_t id;
  std::size_t number;
  friend auto operator<=>(const Born&, const Born&) = default;
};

/// Returns ids of this rank that equal the id of another new surfel, unordered. New ids are processed in
/// chunks.
std::vector<std::uint64_t> takenIds(const Surfels& s, std::size_t first, Reducer& all,
                                    const Surfels* others) {
  constexpr std::size_t piece = std::size_t{1} << 16;
  const std::vector<std::uint64_t> mine(s.id.data() + first, s.id.data() + s.owned);
  const WordNumbers numbers = numberWords(all, mine.size());
  std::vector<std::uint64_t> taken;
  std::vector<Born> born;
  std::vector<std::uint8_t> seen(piece);
  for (std::size_t from = 0; from < numbers.total; from += piece) {
    const std::vector<std::uint64_t> ids = gatherChunk(all, mine, numbers, from,
                                                       std::min(numbers.total, from + piece));
    born.clear();
    for (std::size_t k = 0; k < ids.size(); k++) born.push_back({ids[k], from + k});
    std::sort(born.begin(), born.end());
    std::fill(seen.begin(), seen.end(), 0);
    for (const Born& b : born) seen[b.id % seen.size()] = 1;
    const auto among = [&](std::uint64_t id, std::size_t own) {
      // rejects nearly all ids quickly
      if (!seen[id % seen.size()]) return false;
      auto at = std::lower_bound(born.begin(), born.end(), Born{id, 0});
      if (at != born.end() && at->id == id && at->number == own) ++at;
      return at != born.end() && at->id == id;
    };
    for (std::size_t i = 0; others && i < others->owned; i++)
      if (among(others->id[i], ~std::size_t{0})) taken.push_back(others->id[i]);
    for (std::size_t i = 0; i < s.owned; i++)
      if (among(s.id[i], i < first ? ~std::size_t{0} : numbers.before + i - first)) taken.push_back(s.id[i]);
  }
  return taken;
}

}  // namespace

std::int64_t makeIdsUnique(Surfels& s, std::size_t first, std::uint64_t seed, Reducer& all,
                           const Surfels* others) {
  std::int64_t renamed = 0;
  for (;;) {
    // almost always empty
    std::vector<std::uint64_t> taken = gatherWords(all, takenIds(s, first, all, others));
    if (taken.empty()) return renamed;
    std::sort(taken.begin(), taken.end());
    std::int64_t count[1] = {0};
    for (std::size_t i = first; i < s.owned; i++) {
      if (!std::binary_search(taken.begin(), taken.end(), s.id[i])) continue;
      std::uint64_t place = 0;
      for (int a = 0; a < 3; a++) place = mixBits(place + std::bit_cast<std::uint64_t>(s.position[i][a]));
      s.id[i] = surfelBit | birthBit | randomBits(seed, Purpose::SurfelBirth, s.id[i], place);
      count[0]++;
    }
    all.sum(count);
    renamed += count[0];
  }
}

}  // namespace thaw
