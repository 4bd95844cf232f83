// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/renamed_key.hpp"

namespace thaw {
namespace {

struct RenamedKey {
  const char *former, *name;
};

constexpr RenamedKey renamedKeys[] = {
    {"anchor", "constraint"},          {"crowd", "removal_distance"}, {"brush", "pressure_brush"},
    {"keep_volume", "enforce_volume"}, {"pull", "attraction"},        {"pull_reach", "attraction_range"},
    {"push", "acceleration"},          {"push", "repulsion"},         {"stroke", "line"},
    {"wrap", "shrink_wrap"},           {"wrap_to", "shrink_wrap_to"}};

}  // namespace

std::string renamedKey(const std::string& former, const std::set<std::string>& known) {
  const std::string inTime = "_in_time";
  const bool varies = former.ends_with(inTime);
  const std::string stem = varies ? former.substr(0, former.size() - inTime.size()) : former;
  for (const RenamedKey& k : renamedKeys) {
    std::string name = k.name + (varies ? inTime : "");
    if (stem == k.former && known.contains(name)) return name;
  }
  return {};
}

}  // namespace thaw
