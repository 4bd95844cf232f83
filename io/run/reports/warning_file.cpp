// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/warning_file.hpp"

#include <nlohmann/json.hpp>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {

void writeWarnings(const std::string& out, const std::vector<std::string>& warnings) {
  using Json = nlohmann::ordered_json;
  const Json list = warnings;
  replaceTextFile(out + "/" + warningsName, list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace thaw
