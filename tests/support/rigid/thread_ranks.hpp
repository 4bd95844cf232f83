// SPDX-License-Identifier: Apache-2.0
// Ranks as threads of one process, for tests of collective functions without MPI.
#pragma once
#include <algorithm>
#include <barrier>
#include <cstdint>
#include <map>
#include <span>
#include <thread>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/piece_exchange.hpp"

namespace thaw {

/// State that the threads share.
struct ThreadRanks {
  int count;
  std::barrier<> barrier;
  std::vector<std::span<double>> doubles;
  std::vector<std::span<std::int64_t>> words;
  std::vector<std::vector<WordStream>> sent;
  std::vector<std::span<const std::uint64_t>> ids;

  explicit ThreadRanks(int count)
      : count(count),
        barrier(count),
        doubles(static_cast<std::size_t>(count)),
        words(doubles.size()),
        sent(doubles.size()),
        ids(doubles.size()) {}

  /// Runs body(rank) on a thread for each rank.
  template<class Body> void run(Body&& body) {
    std::vector<std::thread> threads;
    for (int rank = 0; rank < count; rank++) threads.emplace_back([&body, rank] { body(rank); });
    for (std::thread& t : threads) t.join();
  }
};

class ThreadReducer : public Reducer {
 public:
  ThreadReducer(ThreadRanks& ranks, int rank) : ranks_(ranks), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return ranks_.count; }
  void maximum(std::span<double> values) override {
    combine(ranks_.doubles, values, [](double a, double b) { return std::max(a, b); });
  }
  void sum(std::span<std::int64_t> values) override {
    combine(ranks_.words, values, [](std::int64_t a, std::int64_t b) { return a + b; });
  }
  std::vector<WordStream> sparseAllToAll(std::vector<WordStream> lists) override {
    ranks_.sent[static_cast<std::size_t>(rank_)] = std::move(lists);
    ranks_.barrier.arrive_and_wait();
    std::vector<WordStream> received;
    for (int from = 0; from < ranks_.count; from++)
      for (const WordStream& list : ranks_.sent[static_cast<std::size_t>(from)])
        if (list.rank == rank_) received.push_back({from, list.words});
    ranks_.barrier.arrive_and_wait();
    return received;
  }

 private:
  template<class T, class Combine>
  void combine(std::vector<std::span<T>>& all, std::span<T> values, Combine&& both) {
    all[static_cast<std::size_t>(rank_)] = values;
    ranks_.barrier.arrive_and_wait();
    std::vector<T> result(all[0].begin(), all[0].end());
    for (std::size_t r = 1; r < all.size(); r++)
      for (std::size_t k = 0; k < result.size(); k++) result[k] = both(result[k], all[r][k]);
    ranks_.barrier.arrive_and_wait();
    std::copy(result.begin(), result.end(), values.begin());
    ranks_.barrier.arrive_and_wait();
  }
  ThreadRanks& ranks_;
  int rank_;
};

/// Sums over all threads that have a row of the same id.
class ThreadPieceExchange : public PieceExchange {
 public:
  ThreadPieceExchange(ThreadRanks& ranks, int rank, std::span<const std::uint64_t> ids)
      : ranks_(ranks), rank_(static_cast<std::size_t>(rank)), ids_(ids) {}
  void sum(std::span<std::int64_t> words, std::size_t perPiece) override {
    combine(words, perPiece, [](std::int64_t a, std::int64_t b) { return a + b; });
  }
  void minimum(std::span<std::uint64_t> words) override {
    std::vector<std::int64_t> bits(words.begin(), words.end());
    combine(bits, 1, [](std::int64_t a, std::int64_t b) {
      return static_cast<std::uint64_t>(a) < static_cast<std::uint64_t>(b) ? a : b;
    });
    std::copy(bits.begin(), bits.end(), words.begin());
  }
  std::uint64_t id(std::size_t row) const override { return ids_[row]; }
  bool shared(std::size_t) const override { return true; }

 private:
  template<class Combine> void combine(std::span<std::int64_t> words, std::size_t perPiece, Combine&& both) {
    ranks_.words[rank_] = words;
    ranks_.ids[rank_] = ids_;
    ranks_.barrier.arrive_and_wait();
    std::map<std::uint64_t, std::vector<std::int64_t>> results;
    for (std::size_t r = 0; r < ranks_.words.size(); r++)
      for (std::size_t row = 0; row < ranks_.ids[r].size(); row++) {
        const auto first = ranks_.words[r].begin() + static_cast<std::ptrdiff_t>(row * perPiece);
        const auto [at, made] = results.try_emplace(ranks_.ids[r][row], first,
                                                    first + static_cast<std::ptrdiff_t>(perPiece));
        for (std::size_t k = 0; k < perPiece && !made; k++)
          at->second[k] = both(at->second[k], ranks_.words[r][row * perPiece + k]);
      }
    ranks_.barrier.arrive_and_wait();
    for (std::size_t row = 0; row < ids_.size(); row++)
      std::copy(results[ids_[row]].begin(), results[ids_[row]].end(),
                words.begin() + static_cast<std::ptrdiff_t>(row * perPiece));
    ranks_.barrier.arrive_and_wait();
  }
  ThreadRanks& ranks_;
  std::size_t rank_;
  std::span<const std::uint64_t> ids_;
};

}  // namespace thaw
