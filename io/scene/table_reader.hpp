// Reads the keys of one TOML table, or describes them: the same calls give the scene, its error messages and docs/scene.md, so that
// every key is declared once, with its unit, range, default and meaning.
#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "core/scene/scene.hpp"

namespace thaw {

/// An error with its place; sorted by place before they are printed.
struct SceneError { SourcePlace where; std::string text; };

struct Range {
  double low = -never, high = never;
  bool openLow = false, openHigh = false;  ///< the end itself is not allowed
  std::string text() const;                ///< "> 0", "0 ... 1", "" for any number
};
inline Range anyNumber() { return {}; }
inline Range positive() { return {0, never, true, false}; }
inline Range notNegative() { return {0, never, false, false}; }
inline Range between(double low, double high) { return {low, high, false, false}; }

/// A key as docs/scene.md shows it.
struct KeyDescription { std::string table, key, unit, range, standard, about; };

class TableReader {
 public:
  /// Reads `table`, called `path` in messages.
  TableReader(const toml::table& table, std::string path, std::vector<SceneError>& errors);
  /// Describes the keys of the tables called `path`.
  TableReader(std::string path, std::vector<KeyDescription>& descriptions);

  bool describing() const { return table_ == nullptr; }
  SourcePlace place() const;
  SourcePlace placeOf(const char* key) const;
  const std::string& path() const { return path_; }
  void fail(const SourcePlace& where, const std::string& text);
  void fail(const char* key, const std::string& text);
  bool has(const char* key) const { return table_ != nullptr && table_->contains(key); }

  void number(const char* key, double& value, const char* unit, const Range& range, const char* about);
  void number(const char* key, std::optional<double>& value, const char* unit, const Range& range, const char* about);
  void whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high, const char* about);
  void vector(const char* key, Vec3d& value, const char* unit, const char* about);
  void vector(const char* key, std::optional<Vec3d>& value, const char* unit, const char* about);
  void flag(const char* key, bool& value, const char* about);
  void text(const char* key, std::string& value, const char* about);
  void texts(const char* key, std::vector<std::string>& value, const char* about);
  /// One of several words.
  void choice(const char* key, int& value, const std::vector<std::string>& words, const char* about);
  template<class Enum> void choice(const char* key, Enum& value, const std::vector<std::string>& words, const char* about) {
    int number = static_cast<int>(value);
    choice(key, number, words, about);
    value = static_cast<Enum>(number);
  }
  /// A solid and a liquid value: one quantity for both (or for the solid alone), or { solid = ..., liquid = ... }.
  void blend(const char* key, Blend& value, const char* unit, const Range& range, bool liquidToo, const char* about);
  /// A list of pairs of quantities.
  void pairs(const char* key, std::vector<std::pair<double, double>>& value, const char* unit1, const char* unit2, const Range& range2, const char* about);
  /// A key that the caller reads itself: marks it as known, documents it, returns its node (or nullptr).
  const toml::node* node(const char* key, const char* kind, const char* about);
  /// Tables in an array (or one table); calls read for each.
  void tables(const char* key, const char* about, const std::function<void(TableReader&)>& read);
  void table(const char* key, const char* about, const std::function<void(TableReader&)>& read);

  /// A table inside a table of named ones, such as [material.wax].
  void namedTable(const toml::node& node, const std::string& path, const std::function<void(TableReader&)>& read);

  /// A quantity in a node, checked; false (and an error) where it is not one.
  bool quantity(const toml::node& node, const char* key, const char* unit, const Range& range, double& value);
  /// Names every key that was not asked for, with a suggestion.
  void finish();

 private:
  const toml::node* get(const char* key);
  void describe(const char* key, const std::string& unit, const std::string& range, const std::string& standard, const char* about);
  const toml::table* table_ = nullptr;
  std::string path_;
  std::vector<SceneError>* errors_ = nullptr;
  std::vector<KeyDescription>* descriptions_ = nullptr;
  std::set<std::string> known_;
};

/// Where a node stands; nodes that --set made have no file.
SourcePlace placeOfNode(const toml::node& node);
/// The word of the list that is nearest to `word`, or "" where none is near.
std::string nearestWord(const std::string& word, const std::set<std::string>& words);

}  // namespace thaw
