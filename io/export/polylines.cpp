// SPDX-License-Identifier: Apache-2.0
#include "io/export/polylines.hpp"

#include <map>

namespace thaw {

std::vector<std::vector<std::uint32_t>> polylinesOf(std::span<const std::array<std::uint32_t, 2>> lines) {
  std::map<std::uint32_t, std::vector<std::size_t>> linesAt;
  for (std::size_t k = 0; k < lines.size(); k++)
    for (const std::uint32_t v : lines[k]) linesAt[v].push_back(k);
  std::vector<bool> used(lines.size(), false);
  std::vector<std::vector<std::uint32_t>> runs;
  const auto follow = [&](std::uint32_t from, std::size_t line) {
    std::vector<std::uint32_t> run{from};
    while (!used[line]) {
      used[line] = true;
      const std::uint32_t next = lines[line][0] == run.back() ? lines[line][1] : lines[line][0];
      run.push_back(next);
      const std::vector<std::size_t>& here = linesAt[next];
      if (here.size() == 2) line = here[0] == line ? here[1] : here[0];
    }
    runs.push_back(std::move(run));
  };
  for (const bool closed : {false, true})  // open curves first; the lines left are closed ones
    for (const auto& [vertex, here] : linesAt)
      for (const std::size_t line : here)
        if (!used[line] && (closed || here.size() != 2)) follow(vertex, line);
  return runs;
}

}  // namespace thaw
