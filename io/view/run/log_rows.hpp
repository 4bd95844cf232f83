// SPDX-License-Identifier: Apache-2.0
// Columns of a CSV file of a run, for charts.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace thaw {

struct LogRequest {
  std::string path;
  std::vector<std::string> columns;
  std::size_t most = 2000;  ///< rows, about
  std::int64_t known = -1;  ///< bytes of the file at the last request
};

/// Returns bytes, rows and columns by name. Of a long file every 2^k-th row and the last one are returned. An
/// incomplete last line is left out, as are columns that the file lacks. Values are numbers, texts, or null
/// where they are empty or not finite. If the file still has `known` bytes, returns only its size. Throws
/// IoError.
nlohmann::ordered_json logRows(const LogRequest& request);

}  // namespace thaw
