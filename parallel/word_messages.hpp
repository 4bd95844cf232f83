// SPDX-License-Identifier: Apache-2.0
// Messages of 64-bit words to a few ranks, assembled in any order.
#pragma once
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/particles/id_table.hpp"
#include "parallel/sparse_exchange.hpp"

namespace thaw {

/// Words by destination; only destinations in use take memory.
class WordMessages {
 public:
  std::vector<std::uint64_t>& to(int rank) {
    const auto key = static_cast<std::uint64_t>(rank);
    std::uint32_t at = place_.find(key);
    if (at == IdTable::none) {
      at = static_cast<std::uint32_t>(ranks_.size());
      place_.insert(key, at);
      ranks_.push_back({rank, {}});
    }
    return ranks_[at].words;
  }
  std::vector<Message> messages() const {
    std::vector<Message> m;
    for (const Words& w : ranks_) {
      m.push_back({w.rank, std::vector<std::byte>(w.words.size() * sizeof(std::uint64_t))});
      std::memcpy(m.back().bytes.data(), w.words.data(), m.back().bytes.size());
    }
    return m;
  }

 private:
  struct Words {
    int rank;
    std::vector<std::uint64_t> words;
  };
  std::vector<Words> ranks_;
  IdTable place_;
};

inline std::vector<std::uint64_t> wordsOf(const Message& m) {
  std::vector<std::uint64_t> w(m.bytes.size() / sizeof(std::uint64_t));
  if (!w.empty()) std::memcpy(w.data(), m.bytes.data(), w.size() * sizeof(std::uint64_t));
  return w;
}

}  // namespace thaw
