// SPDX-License-Identifier: Apache-2.0
// Disjoint sets, to group joined elements.
#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace thaw {

/// Disjoint sets of 0..n-1; the smallest member represents its set.
struct DisjointSets {
  explicit DisjointSets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i), j = find(j);
    if (i < j) parent[j] = i;
    else parent[i] = j;
  }
  std::vector<std::uint32_t> parent;
};

}  // namespace thaw
