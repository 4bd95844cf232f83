// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/unused_sources.hpp"

#include <fmt/format.h>

#include "io/scene/scene_warnings.hpp"

namespace thaw {

std::vector<std::string> unusedSourceWarnings(const Ledger& ledger, const Scene& s, Reducer& all) {
  const std::vector<SourceUse>& use = ledger.sourceUse;
  std::vector<std::string> lines;
  // Sources that a restart changed have no entries before the first step.
  if (use.size() != s.lamps.size() + s.lasers.size() + s.heatedRegions.size()) return lines;
  std::vector<std::int64_t> absorbed;
  for (const SourceUse& u : use) absorbed.push_back(u.absorbed);
  all.sum(absorbed);
  std::size_t k = 0;
  const auto look = [&](const auto& sources, const char* kind, const char* why) {
    for (const auto& source : sources) {
      if (use[k].given > 0 && absorbed[k] == 0)
        lines.push_back(warningLine(source.where, fmt::format("{} '{}' has given {:.3g} J, and nothing of it "
                                                              "was absorbed: {}",
                                                              kind, source.name, use[k].given, why)));
      k++;
    }
  };
  const char* light = "its light reached no particle of a material with `absorptivity` above 0";
  look(s.lamps, "lamp", light);
  look(s.lasers, "laser", light);
  look(s.heatedRegions, "heated region", "no particle that it heats was in its shape");
  return lines;
}

}  // namespace thaw
