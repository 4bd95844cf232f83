// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/path_names.hpp"

#include <cctype>

namespace thaw {
namespace {

/// title: how messages introduce the object. name: its default name, without the number.
struct DefaultName {
  const char *title, *name, *table;
};

constexpr DefaultName defaultNames[] = {{"oriented body", "oriented", "oriented"},
                                        {"heated region", "heated region", "heated_region"},
                                        {"emitter", "emitter", "emitter"},
                                        {"obstacle", "obstacle", "obstacle"},
                                        {"sheet", "sheet", "sheet"},
                                        {"laser", "laser", "laser"},
                                        {"lamp", "lamp", "lamp"},
                                        {"body", "body", "body"}};

std::string replaced(std::string text, const DefaultName& d) {
  const std::string start = std::string(d.title) + " '" + d.name + " ";
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const std::size_t digits = at + start.size();
    std::size_t end = digits;
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) end++;
    if (end == digits || end == text.size() || text[end] != '\'') continue;
    text.replace(at, end + 1 - at, std::string(d.table) + "." + text.substr(digits, end - digits));
  }
  return text;
}

}  // namespace

std::string withPaths(const std::string& message) {
  std::string text = message;
  for (const DefaultName& d : defaultNames) text = replaced(std::move(text), d);
  return text;
}

}  // namespace thaw
