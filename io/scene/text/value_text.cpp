// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/value_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/scene/shape.hpp"

namespace thaw {

std::string quoted(const std::string& text) {
  std::string s;
  for (const char c : text.substr(0, 60)) s += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  while (text.size() > 60 && !s.empty() && (s.back() & 0x80)) s.pop_back();  // not half a character
  return "\"" + s + (text.size() > 60 ? "...\"" : "\"");
}

std::string shown(const toml::node& n) {
  if (const auto* s = n.as_string()) return quoted(s->get());
  if (const auto* i = n.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = n.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = n.as_boolean()) return b->get() ? "true" : "false";
  return n.is_array() ? "a list" : n.is_table() ? "a table" : "a date or time";
}

std::string numberText(double v) { return v == never ? "\"never\"" : fmt::format("{}", v + 0.0); }

std::string vectorText(const Vec3d& v) {
  return fmt::format("[{}, {}, {}]", numberText(v.x), numberText(v.y), numberText(v.z));
}

std::string listText(const std::vector<std::string>& values) {
  return values.empty() ? "none" : fmt::format("[{}]", fmt::join(values, ", "));
}

std::string listOf(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& w : words) all += (all.empty() ? "\"" : ", \"") + w + "\"";
  return all;
}

}  // namespace thaw
