#include "core/surface/gather_words.hpp"

#include <bit>

namespace thaw {

std::vector<std::uint64_t> gatherWords(Reducer& all, const std::vector<std::uint64_t>& mine) {
  if (all.size() == 1) return mine;
  std::vector<std::int64_t> sizes(static_cast<std::size_t>(all.size()));
  sizes[static_cast<std::size_t>(all.rank())] = static_cast<std::int64_t>(mine.size());
  all.sum(sizes);
  std::size_t before = 0, total = 0;
  for (std::size_t r = 0; r < sizes.size(); r++) {
    if (r < static_cast<std::size_t>(all.rank())) before += static_cast<std::size_t>(sizes[r]);
    total += static_cast<std::size_t>(sizes[r]);
  }
  std::vector<std::int64_t> words(total);  // all others add zeros to ours
  for (std::size_t k = 0; k < mine.size(); k++) words[before + k] = std::bit_cast<std::int64_t>(mine[k]);
  if (total > 0) all.sum(words);
  std::vector<std::uint64_t> gathered(total);
  for (std::size_t k = 0; k < total; k++) gathered[k] = std::bit_cast<std::uint64_t>(words[k]);
  return gathered;
}

}  // namespace thaw
