// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/syntax_hint.hpp"

#include <regex>

namespace thaw {
namespace {

std::string lineOf(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int k = 1; k < line && begin != std::string::npos; k++) {
    begin = text.find('\n', begin);
    if (begin != std::string::npos) begin++;
  }
  if (begin == std::string::npos) return "";
  std::string found = text.substr(begin, text.find('\n', begin) - begin);
  if (!found.empty() && found.back() == '\r') found.pop_back();
  return found;
}

/// Returns whether a line ends inside a text. Comments end a line; escaped quotes do not count.
bool hasOpenQuote(const std::string& line) {
  char quote = 0;
  for (std::size_t k = 0; k < line.size(); k++) {
    const char c = line[k];
    if (quote == '"' && c == '\\') k++;
    else if (quote) quote = c == quote ? 0 : quote;
    else if (c == '#') break;
    else if (c == '"' || c == '\'') quote = c;
  }
  return quote != 0;
}

}  // namespace

std::string syntaxHint(const std::string& text, int line, const std::string& complaint) {
  const std::string here = lineOf(text, line);
  if (complaint.find("parsing string") != std::string::npos && hasOpenQuote(here))
    return "; the closing quote is missing on this line";
  std::smatch m;
  static const std::regex table(
      R"(^\s*\[\s*(body|emitter|obstacle|oriented|sheet|thermostat|lamp|laser|heated_region)\s*\])"),
      quantity(R"(=\s*([-+]?[0-9][-+0-9.eE_]*)\s*([A-Za-z%][^#,\]}]*))");
  if (std::regex_search(here, m, table))
    return "; a table of a list is written [[" + m.str(1) + "]], with two brackets";
  if (std::regex_search(here, m, quantity)) {
    std::string unit = m.str(2);
    while (!unit.empty() && unit.back() == ' ') unit.pop_back();
    return "; a quantity with a unit is a text: \"" + m.str(1) + " " + unit + "\"";
  }
  return "";
}

}  // namespace thaw
