#include "core/surface/rename_twins.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "core/math/hash_random.hpp"
#include "core/surface/gather_words.hpp"
#include "core/surface/sample_mesh.hpp"

namespace thaw {

std::int64_t renameTwins(Surfels& s, std::size_t first, std::uint64_t seed, Reducer& all) {
  std::int64_t renamed = 0;
  for (;;) {
    std::vector<std::uint64_t> born = gatherWords(all, std::vector<std::uint64_t>(s.id.data() + first, s.id.data() + s.owned));
    std::sort(born.begin(), born.end());
    std::vector<std::uint64_t> taken;
    for (std::size_t i = 0; i < first; i++)
      if (std::binary_search(born.begin(), born.end(), s.id[i])) taken.push_back(s.id[i]);
    taken = gatherWords(all, taken);
    for (std::size_t k = 1; k < born.size(); k++)
      if (born[k] == born[k - 1]) taken.push_back(born[k]);
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
