// SPDX-License-Identifier: Apache-2.0
#include "core/halo/spread_labels.hpp"

#include <algorithm>
#include <vector>

namespace thaw {
namespace {

/// Sets the label of each set to the smallest label of its rows on this rank. Returns true if a label of an
/// owned row changed.
bool spreadHere(std::span<std::uint64_t> labels, std::size_t owned, DisjointSets& sets) {
  const std::size_t rows = sets.parent.size();
  std::vector<std::uint64_t> least(rows, ~std::uint64_t{0});
  for (std::uint32_t i = 0; i < rows; i++)
    if (labels[i] != noSet) {
      std::uint64_t& l = least[sets.find(i)];
      l = std::min(l, labels[i]);
    }
  bool changed = false;
  for (std::uint32_t i = 0; i < owned; i++) {
    if (labels[i] == noSet) continue;
    const std::uint64_t l = least[sets.find(i)];
    changed = changed || l != labels[i];
    labels[i] = l;
  }
  return changed;
}

}  // namespace

void spreadLabels(std::span<std::uint64_t> labels, std::size_t owned, DisjointSets& sets, Reducer& all,
                  const std::function<void()>& exchange) {
  for (double changed = 1; changed > 0;) {
    changed = spreadHere(labels, owned, sets) ? 1 : 0;
    all.maximum({&changed, 1});
    if (changed > 0) exchange();
  }
}

}  // namespace thaw
