// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/step_log.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {

void truncateStepLog(const std::string& path, const std::string& head, std::int64_t step) {
  std::ifstream file(path);
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  if (all.rfind(head, 0) != 0) return replaceTextFile(path, head);
  std::string kept = head;
  for (std::size_t at = head.size(), end; (end = all.find('\n', at)) != all.npos; at = end + 1)
    if (std::strtoll(all.c_str() + at, nullptr, 10) <= step) kept += all.substr(at, end + 1 - at);
  if (kept != all) replaceTextFile(path, kept);
}

}  // namespace thaw
