// SPDX-License-Identifier: Apache-2.0
// Points sorted into cubic cells for neighbour searches.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/math/hash_random.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

class PointCells {
 public:
  PointCells(const std::vector<Vec3d>& points, double edge) : back_(1 / edge) {
    for (std::size_t k = 0; k < points.size(); k++)
      for (int a = 0; a < 3; a++) low_[a] = k == 0 ? points[k][a] : std::min(low_[a], points[k][a]);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(points.size());
    for (std::size_t k = 0; k < points.size(); k++)
      keyed[k] = {keyOf(points[k]), static_cast<std::uint32_t>(k)};
    std::sort(keyed.begin(), keyed.end());
    order_.resize(points.size());
    for (std::size_t k = 0; k < keyed.size(); k++) {
      order_[k] = keyed[k].second;
      if (k == 0 || keyed[k].first != keyed[k - 1].first)
        key_.push_back(keyed[k].first), first_.push_back(static_cast<std::uint32_t>(k));
    }
    first_.push_back(static_cast<std::uint32_t>(points.size()));
    std::size_t size = 16;
    while (size < 2 * key_.size()) size *= 2;
    bucket_.assign(size, none);
    for (std::uint32_t c = 0; c < key_.size(); c++) {
      std::size_t s = mixBits(key_[c]) & (size - 1);
      while (bucket_[s] != none) s = (s + 1) & (size - 1);
      bucket_[s] = c;
    }
  }

  /// Returns point indices sorted by cell, and by index within a cell.
  const std::vector<std::uint32_t>& order() const { return order_; }
  std::uint64_t keyOf(const Vec3d& x) const {
    std::uint64_t key = 0;
    for (int a = 2; a >= 0; a--)
      key = key << 21 |
            (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor((x[a] - low_[a]) * back_)) + 2) &
             mask);
    return key;
  }
  /// Calls f(first, last) for the ranges of order() in the 27 cells around x.
  template<class F> void around(const Vec3d& x, F&& f) const {
    const std::uint64_t here = keyOf(x);
    for (std::uint64_t z = 0; z < 3; z++)
      for (std::uint64_t y = 0; y < 3; y++)
        for (std::uint64_t i = 0; i < 3; i++) {
          const std::uint64_t key = here + (z << 42) + (y << 21) + i -
                                    ((std::uint64_t{1} << 42) + (1 << 21) + 1);
          std::size_t s = mixBits(key) & (bucket_.size() - 1);
          while (bucket_[s] != none && key_[bucket_[s]] != key) s = (s + 1) & (bucket_.size() - 1);
          if (bucket_[s] != none) f(first_[bucket_[s]], first_[bucket_[s] + 1]);
        }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::uint64_t mask = (1 << 21) - 1;
  double back_;
  Vec3d low_{};
  std::vector<std::uint32_t> order_, first_, bucket_;
  std::vector<std::uint64_t> key_;
};

}  // namespace thaw
