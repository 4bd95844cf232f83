// SPDX-License-Identifier: Apache-2.0
// Reads the keys of a TOML table, describes them, or records their values in a scene. The same calls give the
// scene, its error messages, docs/scene.md and the restart record. Every key is thus declared once, with
// unit, range, default, meaning, and the effect of a change at a restart.
#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
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
  /// Source: a value, an unknown key of a table, or a check of a table that assumes that its keys are known.
  enum class Kind { Value, UnknownKey, Check } kind = Kind::Value;
  std::string table{};                ///< path of the table of an unknown key or a check, or of a
                                      ///< table without a name; "": the file
  std::vector<SourcePlace> places{};  ///< places of the table of an unknown key and of all its values
  std::string meant{};                ///< key that an unknown one resembles; "": none
};

/// The values of a key as data, for the schema of scene files.
struct KeyForm {
  enum class Type {
    Other,  ///< described only by the text of its range
    Quantity,
    Blend,
    Whole,
    Vector,
    Flag,
    Text,
    Words,
    Choice,
    Pairs,
    Expression,
    Table,
    Tables,
    NamedTables
  };
  Type type = Type::Other;
  Range range{};                      ///< Quantity, Blend, Whole
  std::vector<std::string> words{};   ///< Words, Choice
  std::optional<Type> alternative{};  ///< a second form that the reader accepts
};

/// Words for defaults that are not values.
inline constexpr const char *noDefault = "none", *defaultByScene = "by scene", *defaultRequired = "required";

/// A key as docs/scene.md shows it, or with its value in a scene.
struct KeyDescription {
  std::string table, key, unit, range;
  std::string standard;  ///< default, or value, as in a scene file; or words for none
  std::string about;
  std::optional<Restart> restart{};  ///< none for tables, and for keys of shapes, which follow their table
  SourcePlace where{};               ///< table of a recorded key; without a line if unknown
  KeyForm form{};
};

/// Checks the values of a scene that a program has built. The describing pass collects the defaults, which
/// are always valid; the recording pass checks all values.
struct ValueCheck {
  std::set<std::pair<std::string, double>> defaults{};  ///< key and number
  std::vector<SceneError> errors{};
};

class TableReader {
 public:
  /// Reads `table`, called `path` in messages.
  TableReader(const toml::table& table, std::string path, std::vector<SceneError>& errors);
  enum class Mode { Reading, Describing, Recording };
  /// Describes all keys of the tables called `path`, or records the keys and values of a scene. Recording
  /// calls read functions with the scene's own structs. It omits keys without a value and Restart::Free.
  TableReader(std::string path, std::vector<KeyDescription>& keys, Mode mode);

  /// Checks all values by `check`. Requires: a mode other than Reading.
  void checkBy(ValueCheck& check) { check_ = &check; }

  bool reading() const { return mode_ == Mode::Reading; }
  bool describing() const { return mode_ == Mode::Describing; }
  bool recording() const { return mode_ == Mode::Recording; }
  /// Sets the effect of changes at a restart, for the keys that follow and tables in them.
  void restart(Restart effect) { restart_ = effect; }
  /// Sets the effect for the next key alone. For a table or a list, it concerns presence and order.
  TableReader& as(Restart effect) { return once_ = effect, *this; }
  /// Describes the default of the next key by `words`, such as a value in another unit. It has no effect on
  /// reading and recording.
  TableReader& defaultAs(const char* words) { return default_ = words, *this; }
  /// The same for a default that follows from the scene, and for a key that has none.
  TableReader& byScene() { return defaultAs(defaultByScene); }
  TableReader& needed() { return defaultAs(defaultRequired); }
  /// Describes a second form of the value of the next key.
  TableReader& orAs(KeyForm::Type alternative) { return alternative_ = alternative, *this; }
  const std::string& path() const { return path_; }
  SourcePlace place() const;
  /// Reads the place of the table into `where`, or records its keys with this place.
  void locate(SourcePlace& where);
  SourcePlace placeOf(const std::string& key) const;        ///< place of the value of a key, or of the table
                                                            ///< without it
  std::map<std::string, SourcePlace> placesOfKeys() const;  ///< places of all values in the table
  bool has(const std::string& key) const { return table_ != nullptr && table_->contains(key); }
  bool hasList(const std::string& key) const {
    return table_ != nullptr && table_->get_as<toml::array>(key) != nullptr;
  }
  bool isTable(const std::string& key) const {
    return table_ != nullptr && table_->get_as<toml::table>(key) != nullptr;
  }
  std::string textOf(const std::string& key) const;  ///< a text value, or ""
  /// Adds an error of a check of this table.
  void fail(const SourcePlace& where, const std::string& text);
  /// Adds an error of a check at a key, with its path. A key gets one message: nothing is added if it, or one
  /// of `others` on which the check depends, was refused before.
  void fail(const std::string& key, const std::string& text, std::initializer_list<const char*> others = {});
  /// Reports an invalid value, with the key's path.
  void refuseValue(const std::string& key, const std::string& text);
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
  void blend(const BlendKey& key, Blend& value);
  /// A list of pairs of quantities; the first ones ascend.
  struct PairsKey {
    const char *key, *unit1, *unit2;
    Range range1, range2;
    const char *range, *about;
  };
  void pairs(const PairsKey& key, std::vector<std::pair<double, double>>& value);
  /// Marks a key as known, describes it, and returns its node (or nullptr) to a caller that reads it itself.
  /// value: the value to record.
  const toml::node* node(const char* key, const char* unit, const char* range, const char* about,
                         const std::string& value = "none");
  /// Reads a table with read(reader).
  void table(const char* key, const char* about, const std::function<void(TableReader&)>& read);
  /// The same, but records the table only if `there` is true.
  void table(const char* key, const char* about, bool there, const std::function<void(TableReader&)>& read);
  /// Reads each table of a list, or a single table, with read(reader, element), and appends the element.
  template<class T, class Read>
  void tables(const char* key, const char* about, std::vector<T>& list, const Read& read) {
    if (recording()) return recordList(key, list, read);
    eachTable(key, about, [&](TableReader& r) { readElement(r, list, read); });
  }
  /// Reads named tables, such as [material.wax], in the same way.
  template<class T, class Read>
  void namedTables(const char* key, const char* about, std::vector<T>& list, const Read& read) {
    if (recording()) return recordList(key, list, read);
    eachNamedTable(key, about, [&](const std::string& name, TableReader& r) {
      readElement(r, list, [&](TableReader& table, T& element) {
        element.name = name;
        read(table, element);
      });
    });
  }

  /// Reads and checks a quantity in a node. Returns false, and adds an error, if it is not one.
  bool quantity(const toml::node& node, const char* key, const char* unit, const Range& range, double& value);
  /// Refuses every key that was not read, with a suggestion.
  void finish();
  /// Accepts every key of a table that is refused as a whole.
  void ignoreKeys() { table_ = nullptr; }

 private:
  const toml::node* get(const std::string& key);
  std::string named(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  void describe(KeyDescription key, KeyForm form = {});
  void describeTable(const char* key, KeyForm::Type type, const char* about);
  void checkNumber(const char* key, const char* unit, const Range& range, double value);
  void checkWord(const char* key, int value, const std::vector<std::string>& words);
  bool readVector(const char* key, const char* unit, Vec3d& value);
  TableReader inner(const std::string& path, std::vector<KeyDescription>& keys) const;
  void eachTable(const char* key, const char* about, const std::function<void(TableReader&)>& read);
  void eachNamedTable(const char* key, const char* about,
                      const std::function<void(const std::string&, TableReader&)>& read);
  template<class T, class Read>
  static void readElement(TableReader& r, std::vector<T>& list, const Read& read) {
    T element{};
    if constexpr (requires { element.where; }) r.locate(element.where);
    read(r, element);
    if (r.reading()) list.push_back(std::move(element));
  }
  template<class T, class Read>
  void recordList(const std::string& key, std::vector<T>& list, const Read& read) {
    const std::optional<Restart> order = std::exchange(once_, std::nullopt);
    std::vector<KeyDescription> others;
    for (std::size_t k = 0; k < list.size(); k++) {
      std::string name = std::to_string(k);
      if constexpr (requires { list[k].name; })
        if (!list[k].name.empty()) name = list[k].name;
      std::vector<KeyDescription>& keys = k < mostRecorded ? *keys_ : others;
      if (order) keys.push_back({named(key), name, "(place in the list)", "", std::to_string(k), "", order});
      TableReader r = inner(named(key) + "." + name, keys);
      if constexpr (requires { list[k].where; }) r.locate(list[k].where);
      read(r, list[k]);
    }
    if (!others.empty()) recordOthers(key, others);
  }
  void recordOthers(const std::string& key, const std::vector<KeyDescription>& others);
  void readTable(const toml::node& node, const std::string& path,
                 const std::function<void(TableReader&)>& read);
  void refuse(const std::string& key, const toml::node& node, const std::string& text);
  std::vector<SourcePlace> placesOfTable() const;

  static constexpr std::size_t mostRecorded = 100;  // elements of a list with keys of their own; for more of
                                                    // them the record would be too long

  Mode mode_ = Mode::Reading;
  const toml::table* table_ = nullptr;
  std::string path_;
  std::vector<SceneError>* errors_ = nullptr;
  std::vector<KeyDescription>* keys_ = nullptr;
  ValueCheck* check_ = nullptr;
  std::optional<Restart> restart_, once_;
  std::optional<KeyForm::Type> alternative_;
  const char* default_ = nullptr;
  SourcePlace where_;
  std::set<std::string> known_, refused_;
};

/// Returns the place of a node. Nodes of an override have the file "--set key=value".
SourcePlace placeOfNode(const toml::node& node);

}  // namespace thaw
