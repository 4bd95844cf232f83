// SPDX-License-Identifier: Apache-2.0
// Rows of the ledger over time, in memory.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace thaw {

/// The rows of OUT/ledger.csv since the start or the restart, equal on all ranks.
struct LedgerHistory {
  struct Row {
    std::int64_t step;
    std::vector<double> values;
  };
  std::vector<std::string> names;  ///< columns, with their units
  std::vector<Row> rows;
  /// Removes rows after a step, at a rollback.
  void removeAfter(std::int64_t step) {
    while (!rows.empty() && rows.back().step > step) rows.pop_back();
  }
};

}  // namespace thaw
