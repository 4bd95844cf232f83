// SPDX-License-Identifier: Apache-2.0
#include "core/terms/rows/temperature_uses.hpp"

#include <optional>

namespace thaw {

std::vector<ModuleUse> usesByTemperatures(const Scene& s) {
  std::vector<ModuleUse> uses;
  const auto use = [&](const std::string& why) { uses.push_back({&Modules::heat, why}); };
  std::optional<double> first;
  const auto see = [&](const auto& source, const std::string& who) {
    if (source.temperatureField) return use(who + " has a temperature that depends on position");
    if (!first) first = source.temperature;
    else if (source.temperature != *first) use(who + " differs in temperature from other bodies");
  };
  for (const Body& b : s.bodies) {
    see(b, "body '" + b.name + "'");
    if (length(b.temperatureGradient) > 0) use("body '" + b.name + "' has a temperature gradient");
  }
  for (const Emitter& e : s.emitters) see(e, "emitter '" + e.name + "'");
  return uses;
}

}  // namespace thaw
