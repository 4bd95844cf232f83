// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/pair_sums/pair_sums.hpp"

namespace thaw {

void ClosePairs::append(ClosePairs& pairs, std::uint32_t own, std::uint32_t other) {
  pairs.list.push_back({own, other});
}

}  // namespace thaw
