// SPDX-License-Identifier: Apache-2.0
#include "parallel/word_messages.hpp"

namespace thaw {

std::vector<WordStream> MpiReducer::sparseAllToAll(std::vector<WordStream> lists) {
  constexpr int kind = 26;
  if (comm_.size() == 1) return lists;
  WordMessages out;
  for (WordStream& l : lists) out.to(l.rank) = std::move(l.words);
  std::vector<WordStream> in;
  for (const Message& m : sparseExchange(comm_, out.messages(), kind, MessagesFor::Rows))
    in.push_back({m.rank, wordsOf(m)});
  return in;
}

}  // namespace thaw
