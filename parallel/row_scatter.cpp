// SPDX-License-Identifier: Apache-2.0
#include "parallel/row_scatter.hpp"

#include "parallel/word_messages.hpp"

namespace thaw {

void MpiRowScatter::scatterBack(std::span<const std::uint64_t> source, std::span<const std::uint64_t> values,
                                std::span<std::uint64_t> here) {
  constexpr int kind = 24;
  WordMessages out;
  for (std::size_t k = 0; k < source.size(); k++) {
    const int rank = static_cast<int>(source[k] >> 32);
    const std::uint64_t row = source[k] & 0xffffffffu;
    if (rank == comm_.rank()) {
      here[row] = values[k];
      continue;
    }
    std::vector<std::uint64_t>& words = out.to(rank);
    words.push_back(row);
    words.push_back(values[k]);
  }
  if (comm_.size() == 1) return;
  for (const Message& m : sparseExchange(comm_, out.messages(), kind, MessagesFor::Rows)) {
    const std::vector<std::uint64_t> words = wordsOf(m);
    for (std::size_t k = 0; k + 1 < words.size(); k += 2) here[words[k]] = words[k + 1];
  }
}

}  // namespace thaw
