// SPDX-License-Identifier: Apache-2.0
#include "io/scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

#include "io/scene/resolve_scene.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/path_names.hpp"

namespace thaw {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& l : lines) all += (all.empty() ? "" : "\n") + l;
  return all;
}

/// Replaces control characters by spaces, so that the text is on one line.
std::string oneLine(std::string s) {
  for (char& c : s)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  return s;
}

/// Sorts errors by place and drops duplicates.
std::vector<std::string> linesOf(std::vector<SceneError> errors) {
  std::stable_sort(errors.begin(), errors.end(), [](const SceneError& a, const SceneError& b) {
    return std::tie(a.where.file, a.where.line, a.where.column) <
           std::tie(b.where.file, b.where.line, b.where.column);
  });
  std::vector<std::string> lines;
  for (const SceneError& e : errors) {
    const bool placed = e.where.line > 0 && e.where.file.rfind("--set", 0) != 0;
    const std::string line = oneLine(placed ? fmt::format("{}:{}:{}: error: {}", e.where.file, e.where.line,
                                                          e.where.column, withPaths(e.text))
                                            : fmt::format("{}: error: {}", e.where.file, withPaths(e.text)));
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
  return lines;
}

/// Drops check errors that an unknown key may have caused. Errors of a table (before index `first`) are
/// dropped if that table has an unknown key. Errors over several tables (from `first` on) are dropped at a
/// table with an unknown key. The latter are also dropped if the file has an unknown key outside of all
/// tables. For a missing name, that key must not resemble another table.
void dropFollowOnErrors(std::vector<SceneError>& errors, std::size_t first) {
  using Kind = SceneError::Kind;
  std::set<std::string> tables, meant;  // meant: by unknown keys outside of all tables
  std::vector<SourcePlace> places;
  for (const SceneError& e : errors)
    if (e.kind == Kind::UnknownKey) {
      tables.insert(e.table);
      if (e.table.empty()) meant.insert(e.meant);
      places.insert(places.end(), e.places.begin(), e.places.end());
    }
  const auto at = [](const SourcePlace& p) { return std::tie(p.file, p.line, p.column); };
  const auto explained = [&](const SceneError& e) {
    return e.table.empty() ? !meant.empty() : meant.contains("") || meant.contains(e.table);
  };
  std::vector<SceneError> kept;
  for (std::size_t k = 0; k < errors.size(); k++) {
    const SceneError& e = errors[k];
    const bool here = std::ranges::any_of(places, [&](const SourcePlace& p) { return at(p) == at(e.where); });
    const bool follows = k < first ? e.kind == Kind::Check && tables.count(e.table) > 0
                                   : here || explained(e);
    if (!follows) kept.push_back(e);
  }
  errors = std::move(kept);
}

constexpr const char* givenMark = "# given: ";

/// Returns the scene as one file: `# ---- path`, a line for each override so far, and all keys. Texts are on
/// one line each, so that no other line looks like a mark.
std::string resolvedText(const toml::table& scene, const SceneFiles& files,
                         const std::vector<std::string>& overrides) {
  std::ostringstream text;
  text << oneLine("# ---- " + files.main) << '\n';
  std::istringstream before(files.texts.at(files.main));
  for (std::string line; std::getline(before, line) && line.rfind('#', 0) == 0;)
    if (line.rfind(givenMark, 0) == 0) text << line << '\n';
  for (const std::string& o : overrides) text << oneLine(givenMark + ("--set " + o)) << '\n';
  toml::format_flags flags = toml::toml_formatter::default_flags;
  flags &= ~(toml::format_flags::allow_multi_line_strings | toml::format_flags::allow_literal_strings);
  text << toml::toml_formatter(scene, flags) << '\n';
  return text.str();
}

}  // namespace

SceneErrors::SceneErrors(std::vector<std::string> all)
    : std::runtime_error(joined(all)), lines(std::move(all)) {}

Scene readScene(const SceneFiles& files, const std::vector<std::string>& overrides) {
  if (const auto p = files.problems.find(files.main); p != files.problems.end())
    throw SceneErrors({oneLine(files.main + ": error: " + p->second)});
  Scene s;
  s.file = files.main;
  SceneReading reading;
  reading.scene = &s;
  reading.start = {files.main, 1, 1};
  std::vector<SceneError> errors;
  const toml::table table = resolveScene(files, overrides, errors);
  const bool whole = errors.empty();
  if (!table.empty() || whole) {
    TableReader top(table, "", errors);
    readSections(top, reading);
    top.finish();
    const std::size_t first = errors.size();
    if (whole) checkScene(reading, errors);  // otherwise a missing key may be in an unreadable file
    dropFollowOnErrors(errors, first);
  }
  if (!errors.empty()) throw SceneErrors(linesOf(std::move(errors)));
  s.text = resolvedText(table, files, overrides);
  return s;
}

Scene readScene(const std::string& path, const std::vector<std::string>& overrides) {
  return readScene(loadSceneFiles(path), overrides);
}

}  // namespace thaw
