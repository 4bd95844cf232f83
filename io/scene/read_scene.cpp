#include "io/scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "io/output/frame_fields.hpp"
#include "io/scene/read_sections.hpp"

namespace thaw {
namespace {

constexpr std::uintmax_t largestFile = 16u << 20;

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& l : lines) all += (all.empty() ? "" : "\n") + l;
  return all;
}

/// The text of a file, or why it cannot be had.
std::string readText(const std::string& path, std::string& problem) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) return problem = "no such file", "";
  if (!std::filesystem::is_regular_file(status)) return problem = "not a file", "";
  if (std::filesystem::file_size(path, code) > largestFile) return problem = "larger than 16 MiB: not a scene", "";
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) return problem = "cannot be read", "";
  if (text.str().find('\0') != std::string::npos) return problem = "has a zero byte: not a text file", "";
  return text.str();
}

/// Paths that a parsed file includes.
std::vector<std::pair<std::string, SourcePlace>> includesOf(const toml::table& t, const std::string& path, std::vector<SceneError>* errors) {
  std::vector<std::pair<std::string, SourcePlace>> all;
  const auto add = [&](const toml::node& n) {
    if (const auto* s = n.as_string()) all.push_back({(std::filesystem::path(path).parent_path() / s->get()).lexically_normal().string(), placeOfNode(n)});
    else if (errors) errors->push_back({placeOfNode(n), "include: expected a path or a list of paths"});
  };
  const toml::node* n = t.get("include");
  if (!n) return all;
  if (const toml::array* a = n->as_array()) {
    for (const toml::node& e : *a) add(e);
  } else {
    add(*n);
  }
  return all;
}

void load(SceneFiles& files, const std::string& path, int depth) {
  if (files.texts.count(path) || files.problems.count(path)) return;
  std::string problem;
  std::string text = readText(path, problem);
  if (!problem.empty()) {
    files.problems[path] = problem;
    return;
  }
  files.texts[path] = text;
  if (depth > 16) return;
  try {
    const toml::table t = toml::parse(text, path);
    for (const auto& [other, where] : includesOf(t, path, nullptr)) load(files, other, depth + 1);
  } catch (const toml::parse_error&) {  // reported when the scene is read
  }
}

struct Parser {
  const SceneFiles& files;
  SceneReading& reading;
  std::vector<SceneError>& errors;
  std::vector<std::string> stack;
  std::set<std::string> done;

  /// Reads a file's includes, then the file itself, so that it can say what the includes said otherwise.
  void read(const std::string& path, const SourcePlace& from, const std::vector<std::string>& overrides) {
    if (std::find(stack.begin(), stack.end(), path) != stack.end()) return errors.push_back({from, "'" + path + "' includes itself"});
    if (!done.insert(path).second) return;
    if (const auto p = files.problems.find(path); p != files.problems.end()) return errors.push_back({from, "'" + path + "': " + p->second});
    const auto text = files.texts.find(path);
    if (text == files.texts.end()) return errors.push_back({from, "'" + path + "': was not read"});
    toml::table t;
    try {
      t = toml::parse(text->second, path);
    } catch (const toml::parse_error& e) {
      const auto& at = e.source().begin;
      return errors.push_back({{path, static_cast<int>(at.line), static_cast<int>(at.column)}, std::string(e.description())});
    }
    stack.push_back(path);
    for (const auto& [other, where] : includesOf(t, path, &errors)) read(other, where, {});
    stack.pop_back();
    for (const std::string& o : overrides) apply(t, o);
    reading.folder = std::filesystem::path(path).parent_path().string();
    TableReader top(t, "", errors);
    readSections(top, reading);
    top.finish();
  }

  void wrong(const std::string& setting, const std::string& what) { errors.push_back({{"--set " + setting, 0, 0}, what}); }

  /// Puts the value of `key=value` where the dotted key says, making tables on the way.
  void apply(toml::table& top, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) return wrong(setting, "expected key=value");
    const std::string value = setting.substr(equals + 1);
    std::vector<std::string> keys;
    std::stringstream path(setting.substr(0, equals));
    for (std::string part; std::getline(path, part, '.');) keys.push_back(part);
    toml::table parsed;
    try {
      parsed = toml::parse("v = " + value, "--set " + setting);
    } catch (const toml::parse_error&) {  // not a TOML value: a text, such as 1 mm
      parsed.insert_or_assign("v", value);
    }
    toml::table* t = &top;
    for (std::size_t k = 0; k + 1 < keys.size(); k++) {
      toml::node* n = t->get(keys[k]);
      if (!n) {
        t->insert_or_assign(keys[k], toml::table{});
        n = t->get(keys[k]);
      }
      if (toml::array* a = n->as_array()) {
        if (k + 2 >= keys.size() + 0 && k + 1 >= keys.size()) return wrong(setting, "'" + keys[k] + "' is a list: say which by its number or name");
        toml::node* element = find(*a, keys[k + 1]);
        if (!element) return wrong(setting, "'" + keys[k] + "' has nothing called or numbered '" + keys[k + 1] + "'");
        n = element;
        k++;
        if (k + 1 >= keys.size()) return wrong(setting, "a key of '" + keys[k] + "' is missing");
      }
      t = n->as_table();
      if (!t) return wrong(setting, "'" + keys[k] + "' is not a table");
    }
    t->insert_or_assign(keys.back(), std::move(*parsed.get("v")));
  }

  static toml::node* find(toml::array& a, const std::string& which) {
    for (toml::node& e : a)
      if (toml::table* t = e.as_table())
        if (const auto name = (*t)["name"].value<std::string>(); name && *name == which) return &e;
    char* end = nullptr;
    const unsigned long k = std::strtoul(which.c_str(), &end, 10);
    return !which.empty() && *end == 0 && k < a.size() ? a.get(k) : nullptr;
  }
};

}  // namespace

SceneErrors::SceneErrors(std::vector<std::string> all) : std::runtime_error(joined(all)), lines(std::move(all)) {}

SceneFiles loadSceneFiles(const std::string& path) {
  SceneFiles files;
  files.main = path;
  load(files, path, 0);
  return files;
}

Scene readScene(const SceneFiles& files, const std::vector<std::string>& overrides) {
  Scene s;
  s.file = files.main;
  SceneReading reading;
  reading.scene = &s;
  std::vector<SceneError> errors;
  if (const auto p = files.problems.find(files.main); p != files.problems.end()) throw SceneErrors({files.main + ": error: " + p->second});
  Parser parser{files, reading, errors, {}, {}};
  parser.read(files.main, {files.main, 1, 1}, overrides);
  if (errors.empty()) checkScene(reading, errors);
  const std::vector<std::string> known = knownFrameFields();
  for (const std::string& f : s.output.fields)
    if (std::find(known.begin(), known.end(), f) == known.end()) {
      const std::string near = nearestWord(f, {known.begin(), known.end()});
      errors.push_back({{files.main, 1, 1}, "output.fields: there is no field '" + f + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?")});
    }
  if (!errors.empty()) {
    std::stable_sort(errors.begin(), errors.end(), [](const SceneError& a, const SceneError& b) {
      return std::tie(a.where.file, a.where.line, a.where.column) < std::tie(b.where.file, b.where.line, b.where.column);
    });
    std::vector<std::string> lines;
    for (const SceneError& e : errors)
      lines.push_back(e.where.line > 0 ? fmt::format("{}:{}:{}: error: {}", e.where.file, e.where.line, e.where.column, e.text)
                                       : fmt::format("{}: error: {}", e.where.file.empty() ? files.main : e.where.file, e.text));
    throw SceneErrors(std::move(lines));
  }
  for (const auto& [path, text] : files.texts) s.text += "# ---- " + path + "\n" + text + (text.empty() || text.back() == '\n' ? "" : "\n");
  for (const std::string& o : overrides) s.text += "# --set " + o + "\n";
  return s;
}

std::string sceneDocumentation() {
  std::vector<KeyDescription> keys;
  Scene s;
  SceneReading reading;
  reading.scene = &s;
  TableReader top("", keys);
  readSections(top, reading);
  std::string text =
      "# Keys of a scene file\n\n"
      "Generated from the table of keys in the code by `thaw docs`; a test holds it against the code. A quantity is a number in SI\n"
      "or a text with a unit (`\"15 cm\"`, `\"2 kJ/kg\"`, `\"56 degC\"`, `\"30 deg\"`); temperatures without a unit are in kelvin. An unknown key\n"
      "is an error. `--set key=value` on the command line overrides a key: `--set spacing=\"1 mm\"`, `--set material.wax.young=\"1 MPa\"`,\n"
      "`--set body.bust.velocity=\"[0, 0, -1]\"` (a body by its name or number).\n";
  // tables in the order of their first key; nested tables follow their own
  std::vector<std::string> tables;
  for (const KeyDescription& k : keys)
    if (std::find(tables.begin(), tables.end(), k.table) == tables.end()) tables.push_back(k.table);
  for (const std::string& t : tables) {
    text += t.empty() ? "\n## Top level\n\n" : "\n## `" + t + "`\n\n";
    text += "| key | unit | range | default | what it is |\n|---|---|---|---|---|\n";
    for (const KeyDescription& k : keys)
      if (k.table == t) text += fmt::format("| `{}` | {} | {} | {} | {} |\n", k.key, k.unit, k.range, k.standard, k.about);
  }
  return text;
}

}  // namespace thaw
