// SPDX-License-Identifier: Apache-2.0
#include "io/scene/resolve_scene.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "core/geometry/builtin/builtin_meshes.hpp"
#include "io/scene/text/nearest_word.hpp"
#include "io/scene/text/syntax_hint.hpp"

namespace thaw {
namespace {

using std::filesystem::path;

bool isJoined(std::string_view key) {
  return key == "body" || key == "emitter" || key == "obstacle" || key == "thermostat" || key == "oriented" ||
         key == "sheet" || key == "lamp" || key == "laser" || key == "heated_region";
}

/// Moves the content of `from` into `to`. Moved nodes keep their places; copies would not.
void merge(toml::table& to, toml::table& from, bool top) {
  for (auto&& [key, node] : from) {
    if (top && key.str() == "include") continue;
    toml::node* old = to.get(key.str());
    if (old && old->is_table() && node.is_table()) {
      merge(*old->as_table(), *node.as_table(), false);
    } else if (old && top && isJoined(key.str()) && old->is_array() && node.is_array()) {
      for (toml::node& e : *node.as_array()) old->as_array()->push_back(std::move(e));
    } else {
      to.erase(key.str());  // so that the key, too, has its new place
      to.insert(key, std::move(node));
    }
  }
}

/// Returns the message of a parser without its first word "Error", which the line of the error already has.
std::string complaintOf(const toml::parse_error& e) {
  const std::string_view text = e.description(), first = "Error ";
  return std::string(text.starts_with(first) ? text.substr(first.size()) : text);
}

struct Resolver {
  const SceneFiles& files;
  std::vector<SceneError>& errors;
  toml::table merged{};
  std::vector<std::string> open{};  ///< files that are being read
  std::set<std::string> done{};

  /// Merges the includes of a file, then the file itself, which thus takes precedence.
  void read(const std::string& file, const SourcePlace& from) {
    if (std::find(open.begin(), open.end(), file) != open.end()) {
      std::string chain;
      for (auto f = std::find(open.begin(), open.end(), file); f != open.end(); ++f) chain += *f + " -> ";
      return errors.push_back({from, "include: '" + file + "' includes itself: " + chain + file});
    }
    if (done.count(file)) return;
    if (const auto p = files.problems.find(file); p != files.problems.end())
      return errors.push_back({from, "include: '" + file + "': " + p->second});
    const auto text = files.texts.find(file);
    if (text == files.texts.end())
      return errors.push_back({from, "include: '" + file + "': includes are nested more than " +
                                         std::to_string(deepestInclude) + " deep"});
    done.insert(file);
    toml::table t;
    try {
      t = toml::parse(text->second, file);
    } catch (const toml::parse_error& e) {
      const auto& at = e.source().begin;
      const std::string complaint = complaintOf(e);
      return errors.push_back({{file, static_cast<int>(at.line), static_cast<int>(at.column)},
                               complaint + syntaxHint(text->second, static_cast<int>(at.line), complaint)});
    }
    open.push_back(file);
    for (const auto& [other, where] : includesOf(t, file, &errors)) read(other, where);
    open.pop_back();
    merge(merged, t, true);
  }
};

/// Makes the paths of meshes absolute. They are relative to the file that names them, or to the working
/// folder for overrides.
void placeMeshes(toml::node& n, const std::string& base) {
  if (toml::array* a = n.as_array()) {
    for (toml::node& e : *a) placeMeshes(e, base);
  } else if (toml::table* t = n.as_table()) {
    for (auto&& [key, node] : *t) {
      auto* s = key.str() == "mesh" ? node.as_string() : nullptr;
      if (!s) {
        placeMeshes(node, base);
      } else if (!s->get().empty() && !namesBuiltin(s->get())) {
        const std::string file = placeOfNode(node).file;
        const path folder = file.rfind("--set", 0) == 0 ? path(base) : path(base) / path(file).parent_path();
        s->get() = (folder / s->get()).lexically_normal().string();
      }
    }
  }
}

/// Returns the keys of a dotted key, or nothing for another text.
std::vector<std::string> keysOf(const std::string& dotted) {
  std::vector<std::string> keys(1);
  char quote = 0;
  for (const char c : dotted) {
    if (quote && c == quote) quote = 0;
    else if (!quote && (c == '"' || c == '\'')) quote = c;
    else if (!quote && c == '.') keys.emplace_back();
    else if (quote || (c != ' ' && c != '\t')) keys.back() += c;
  }
  for (const std::string& k : keys)
    if (k.empty() || quote || keys.size() > 32) return {};
  return keys;
}

/// Returns the names of the tables of a list.
std::set<std::string> namesIn(const toml::array& a) {
  std::set<std::string> names;
  for (const toml::node& e : a)
    if (const toml::table* t = e.as_table())
      if (const auto* name = t->get_as<std::string>("name")) names.insert(name->get());
  return names;
}

/// Returns the table of a list with this name or number.
toml::table* findTable(toml::array& a, const std::string& which) {
  for (toml::node& e : a)
    if (toml::table* t = e.as_table())
      if (const auto* name = t->get_as<std::string>("name"); name && name->get() == which) return t;
  std::size_t k = 0;
  const auto [end, code] = std::from_chars(which.data(), which.data() + which.size(), k);
  return code == std::errc() && end == which.data() + which.size() && k < a.size() ? a.get(k)->as_table()
                                                                                   : nullptr;
}

}  // namespace

std::vector<std::pair<std::string, SourcePlace>> includesOf(const toml::table& t, const std::string& file,
                                                            std::vector<SceneError>* errors) {
  std::vector<std::pair<std::string, SourcePlace>> all;
  const auto add = [&](const toml::node& n) {
    const auto* s = n.as_string();
    if (s && !s->get().empty())
      all.push_back({(path(file).parent_path() / s->get()).lexically_normal().string(), placeOfNode(n)});
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

void applyOverride(toml::table& top, const std::string& setting, std::vector<SceneError>& errors) {
  const std::string source = "--set " + setting;
  const auto wrong = [&](const std::string& what) {
    SceneError& e = errors.emplace_back();
    e.where.file = source;
    e.text = what;
  };
  const std::size_t equals = setting.find('=');
  const std::vector<std::string> keys = equals == std::string::npos ? std::vector<std::string>{}
                                                                    : keysOf(setting.substr(0, equals));
  if (keys.empty()) return wrong("expected key=value with a dotted key such as material.wax.young=\"1 MPa\"");
  if (keys[0] == "include") return wrong("include: only scene files can include files");
  const auto parse = [&](const std::string& text) { return toml::parse(text, source); };
  toml::table value;
  try {
    value = parse("v = " + setting.substr(equals + 1));
  } catch (const toml::parse_error&) {  // not a TOML value but a text, such as 1 mm
  }
  if (value.size() != 1) {
    value = parse("v = ''");
    value.get_as<std::string>("v")->get() = setting.substr(equals + 1);
  }
  toml::table* t = &top;
  for (std::size_t k = 0; k + 1 < keys.size(); k++) {
    if (!t->contains(keys[k])) t->insert(keys[k], std::move(*parse("v = {}").get("v")));
    toml::node* n = t->get(keys[k]);
    if (toml::array* list = n->as_array()) {
      if (k + 2 >= keys.size())
        return wrong("'" + keys[k] + "' is a list: expected the name or number of an entry, then a key");
      t = findTable(*list, keys[k + 1]);
      if (!t)
        return wrong("'" + keys[k] + "' has no entry with the name or number '" + keys[k + 1] + "'" +
                     suggestion(keys[k + 1], namesIn(*list)));
      k++;
    } else {
      t = n->as_table();
      if (!t) return wrong("'" + keys[k] + "' is not a table");
    }
  }
  t->erase(keys.back());  // so that the key, too, has its new place
  t->insert(toml::key(keys.back(), value.get("v")->source()), std::move(*value.get("v")));
}

toml::table resolveScene(const SceneFiles& files, const std::vector<std::string>& overrides,
                         std::vector<SceneError>& errors) {
  Resolver r{files, errors};
  r.read(files.main, {files.main, 1, 1});
  for (const std::string& o : overrides) applyOverride(r.merged, o, errors);
  for (auto&& [key, node] : r.merged)
    if (isJoined(key.str())) placeMeshes(node, files.base);
  return std::move(r.merged);
}

}  // namespace thaw
