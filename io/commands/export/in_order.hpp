// SPDX-License-Identifier: Apache-2.0
// Parallel work whose results are consumed in order.
#pragma once
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>

#include "io/image/parallel_for.hpp"

namespace thaw {

/// Calls use(i, make(i)) for i = 0 .. count - 1: make on several threads, use in the order of i and by one
/// thread at a time. Each thread holds at most one result. Rethrows the first exception.
template<class Make, class Use> void parallelInOrder(std::size_t count, int threads, Make make, Use use) {
  std::mutex guard;
  std::condition_variable changed;
  std::size_t turn = 0;
  bool failed = false;
  parallelFor(count, threads, [&](std::size_t i) {
    try {
      auto result = make(i);
      std::unique_lock lock(guard);
      changed.wait(lock, [&] { return turn == i || failed; });
      if (failed) return;
      use(i, std::move(result));
      turn++;
      changed.notify_all();
    } catch (...) {
      {
        const std::lock_guard lock(guard);
        failed = true;
      }
      changed.notify_all();
      throw;
    }
  });
}

}  // namespace thaw
