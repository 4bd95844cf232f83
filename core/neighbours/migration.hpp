// SPDX-License-Identifier: Apache-2.0
// Rows that a migration moves between ranks.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thaw {

/// Rows that left this rank in a migration, and arrived rows, which are appended behind the owned ones.
struct Migration {
  std::vector<std::uint32_t> departed;  ///< rows, ascending; still in the table until it is reordered
  std::vector<int> departedTo;          ///< destination rank of each departed row
  std::size_t arrivals = 0;             ///< the last `arrivals` owned rows are new
};

}  // namespace thaw
