// SPDX-License-Identifier: Apache-2.0
// Reads the keys of a TOML table, or describes them. The same calls give the scene, its error messages and
// docs/scene.md. Every key is thus declared once, with unit, range, default and meaning.
#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "core/scene/scene.hpp"
#include "io/scene/text/range.hpp"

namespace thaw {

/// An error with its place. Errors are sorted by place before they are printed. A file name that starts with
/// "--set" has no line.
struct SceneError {
  SourcePlace where;
  std::string text;
};

/// A key as docs/scene.md shows it.
struct KeyDescription {
  std::string table, key, unit, range, standard, about;
  std::vector<std::string> words{};  ///< words of a choice, by number, or of a flag
};

class TableReader {
 public:
  /// Reads `table`, called `path` in messages.
  TableReader(const toml::table& table, std::string path, std::vector<SceneError>& errors);
  /// Describes the keys of the tables called `path`.
  TableReader(std::string path, std::vector<KeyDescription>& descriptions);

  bool describing() const { return table_ == nullptr; }
  const std::string& path() const { return path_; }
  SourcePlace place() const;
  SourcePlace placeOf(const std::string& key) const;  ///< place of the value of a key, or of the table
                                                      ///< without it
  bool has(const std::string& key) const { return table_ != nullptr && table_->contains(key); }
  bool hasList(const std::string& key) const {
    return table_ != nullptr && table_->get_as<toml::array>(key) != nullptr;
  }
  std::string textOf(const std::string& key) const;  ///< a text value, or ""
  void fail(const SourcePlace& where, const std::string& text);
  /// Adds an error at a key, with its path. A key gets one message: nothing is added if it, or one of
  /// `others` on which the check depends, was refused before.
  void fail(const std::string& key, const std::string& text, std::initializer_list<const char*> others = {});
  bool refused(const std::string& key) const { return refused_.count(key) > 0; }

  // Each function reads a key into `value` if it exists, else leaves the default, which is described.
  void number(const char* key, double& value, const char* unit, const Range& range, const char* about);
  void number(const char* key, std::optional<double>& value, const char* unit, const Range& range,
              const char* about);
  void whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high, const char* about);
  void vector(const char* key, Vec3d& value, const char* unit, const char* about);
  void vector(const char* key, std::optional<Vec3d>& value, const char* unit, const char* about);
  void flag(const char* key, bool& value, const char* about);
  void text(const char* key, std::string& value, const char* about, const char* range = "text");
  /// Reads a list of words.
  void words(const char* key, std::vector<std::string>& value, const std::vector<std::string>& allowed,
             const char* about);
  /// Reads one of several words, as its number.
  void choice(const char* key, int& value, const std::vector<std::string>& words, const char* about);
  template<class Enum>
  void choice(const char* key, Enum& value, const std::vector<std::string>& words, const char* about) {
    int number = static_cast<int>(value);
    choice(key, number, words, about);
    value = static_cast<Enum>(number);
  }
  /// Value of the liquid if only one quantity is given.
  enum class Liquid { Same, Unchanged };
  /// A value for solid and liquid: one quantity, or { solid = ..., liquid = ... }.
  struct BlendKey {
    const char *key, *unit;
    Range range;
    Liquid liquid;
    const char* about;
  };
  void blend(const BlendKey& key, Blend& value);
  /// A list of pairs of quantities; the first ones ascend.
  struct PairsKey {
    const char *key, *unit1, *unit2;
    Range range1, range2;
  };
  void pairs(const PairsKey& key, std::vector<std::pair<double, double>>& value);
  /// Marks a key as known, describes it, and returns its node (or nullptr) to a caller that reads it itself.
  const toml::node* node(const char* key, const char* unit, const char* range, const char* about);
  /// Calls read for each table of a list, or for a single table.
  void tables(const char* key, const char* about, const std::function<void(TableReader&)>& read);
  void table(const char* key, const char* about, const std::function<void(TableReader&)>& read);
  /// Calls read(name, table) for each named table, such as [material.wax].
  void namedTables(const char* key, const char* about,
                   const std::function<void(const std::string&, TableReader&)>& read);

  /// Reads and checks a quantity in a node. Returns false, and adds an error, if it is not one.
  bool quantity(const toml::node& node, const char* key, const char* unit, const Range& range, double& value);
  /// Refuses every key that was not read, with a suggestion.
  void finish();

 private:
  const toml::node* get(const std::string& key);
  std::string named(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  void describe(const char* key, const std::string& unit, const std::string& range,
                const std::string& standard, const char* about);
  void readTable(const toml::node& node, const std::string& path,
                 const std::function<void(TableReader&)>& read);
  void refuse(const std::string& key, const toml::node& node, const std::string& text);

  const toml::table* table_ = nullptr;
  std::string path_;
  std::vector<SceneError>* errors_ = nullptr;
  std::vector<KeyDescription>* descriptions_ = nullptr;
  std::set<std::string> known_, refused_;
};

/// Returns the place of a node. Nodes of an override have the file "--set key=value".
SourcePlace placeOfNode(const toml::node& node);

}  // namespace thaw
