// SPDX-License-Identifier: Apache-2.0
#include "io/run/resolution_line.hpp"

#include <fmt/format.h>

namespace thaw {
namespace {

constexpr std::size_t mostBodies = 6;  // bodies listed one by one

/// Returns whether an override sets a spacing or the quality.
bool isOfResolution(const std::string& override) {
  std::string key = override.substr(0, override.find('='));
  while (!key.empty() && key.back() == ' ') key.pop_back();
  const std::string last = key.substr(key.rfind('.') + 1);  // the whole key if it has no point
  return last == "spacing" || key == "quality";
}

const char* nameOf(Quality q) {
  return q == Quality::Preview ? "preview" : q == Quality::Reference ? "reference" : "standard";
}

}  // namespace

std::string resolutionLine(const Scene& s, const std::vector<std::string>& overrides) {
  std::string line = fmt::format("spacing {:g} m", s.spacing);
  std::size_t listed = 0;
  const auto add = [&](const auto& bodies, const char* what) {
    for (const auto& b : bodies)
      if (b.spacing > 0 && ++listed <= mostBodies)
        line += fmt::format(", {} '{}' {:g} m", what, b.name, b.spacing);
  };
  add(s.oriented, "oriented body");
  add(s.sheets, "sheet");
  if (listed > mostBodies) line += fmt::format(", and {} more with their own", listed - mostBodies);
  if (s.surface.on) line += fmt::format(", surfels {:g} m", surfelSpacing(s));
  line += fmt::format("; quality {}", nameOf(s.quality));
  std::string by;
  for (const std::string& o : overrides)
    if (isOfResolution(o)) by += (by.empty() ? " (--set " : ", --set ") + o;
  return line + by + (by.empty() ? "" : ")");
}

}  // namespace thaw
