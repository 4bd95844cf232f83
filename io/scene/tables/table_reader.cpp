// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/scene/text/checksum.hpp"
#include "io/scene/text/nearest_word.hpp"
#include "io/scene/text/renamed_key.hpp"
#include "io/scene/text/units.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {
namespace {

/// Returns the range with the unit behind its numbers: "> 0 Pa or "never"".
std::string withUnit(std::string range, const std::string& unit) {
  if (unit.empty() || unit == "1") return range;
  return range.insert(std::min(range.find(" or \""), range.size()), " " + unit);
}

/// Returns a long text as its length and checksum.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 200;
  if (text.size() <= most) return text;
  return fmt::format("a text of {} characters with checksum {:x}", text.size(), Checksum().add(text).value);
}

}  // namespace

SourcePlace placeOfNode(const toml::node& n) {
  const toml::source_region& s = n.source();
  return {s.path ? *s.path : std::string("--set"), static_cast<int>(s.begin.line),
          static_cast<int>(s.begin.column)};
}

TableReader::TableReader(const toml::table& table, std::string path, std::vector<SceneError>& errors)
    : table_(&table), path_(std::move(path)), errors_(&errors) {}
TableReader::TableReader(std::string path, std::vector<KeyDescription>& keys, Mode mode)
    : mode_(mode), path_(std::move(path)), keys_(&keys) {}

SourcePlace TableReader::place() const { return table_ ? placeOfNode(*table_) : SourcePlace{}; }
SourcePlace TableReader::placeOf(const std::string& key) const {
  const toml::node* n = table_ ? table_->get(key) : nullptr;
  return n ? placeOfNode(*n) : place();
}
std::map<std::string, SourcePlace> TableReader::placesOfKeys() const {
  std::map<std::string, SourcePlace> places;
  for (const auto& [key, node] : *table_) places[std::string(key.str())] = placeOfNode(node);
  return places;
}
std::string TableReader::textOf(const std::string& key) const {
  const auto* s = table_ ? table_->get_as<std::string>(key) : nullptr;
  return s ? s->get() : std::string();
}
void TableReader::fail(const SourcePlace& where, const std::string& text) {
  if (errors_) errors_->push_back({where, text, SceneError::Kind::Check, path_});
}
void TableReader::fail(const std::string& key, const std::string& text,
                       std::initializer_list<const char*> others) {
  if (refused(key) ||
      std::any_of(others.begin(), others.end(), [&](const char* other) { return refused(other); }))
    return;
  refused_.insert(key);
  fail(placeOf(key), named(key) + ": " + text);
}
void TableReader::refuseValue(const std::string& key, const std::string& text) {
  if (!errors_ || !refused_.insert(key).second) return;
  errors_->push_back({placeOf(key), named(key) + ": " + text});
}
/// Adds an error at a node of the value of a key; several nodes may be wrong.
void TableReader::refuse(const std::string& key, const toml::node& n, const std::string& text) {
  refused_.insert(key);
  if (errors_) errors_->push_back({placeOfNode(n), named(key) + ": " + text});
}

const toml::node* TableReader::get(const std::string& key) {
  known_.insert(key);
  return table_ ? table_->get(key) : nullptr;
}

void TableReader::describe(KeyDescription k, KeyForm form) {
  known_.insert(k.key);
  const std::optional<Restart> once = std::exchange(once_, std::nullopt);
  form.alternative = std::exchange(alternative_, std::nullopt);
  const char* const shown = std::exchange(default_, nullptr);
  if (reading()) return;
  if (describing() && shown) k.standard = shown;
  k.table = path_;
  k.form = std::move(form);
  if (!k.restart) k.restart = once ? once : restart_;
  if (recording()) {
    if (k.standard == "none" || !k.restart || *k.restart == Restart::Free) return;
    k.standard = shortened(k.standard);
    k.where = where_;
  }
  keys_->push_back(std::move(k));
}

/// Describes a key whose value is a table or several.
void TableReader::describeTable(const char* key, KeyForm::Type type, const char* about) {
  known_.insert(key);
  const std::optional<Restart> once = std::exchange(once_, std::nullopt);
  const char* range = type == KeyForm::Type::Table    ? "table"
                      : type == KeyForm::Type::Tables ? "list of tables"
                                                      : "tables by name";
  if (describing()) keys_->push_back({path_, key, "", range, "none", about, once, {}, {type}});
}

TableReader TableReader::inner(const std::string& path, std::vector<KeyDescription>& keys) const {
  TableReader r(path, keys, mode_);
  r.check_ = check_;
  r.restart_ = restart_;
  r.where_ = where_;
  return r;
}

void TableReader::locate(SourcePlace& where) {
  if (reading()) where = place();
  if (recording()) where_ = where;
}

void TableReader::recordOthers(const std::string& key, const std::vector<KeyDescription>& others) {
  std::map<Restart, Checksum> sums;
  for (const KeyDescription& k : others) sums[*k.restart].add(k.table).add(k.key).add(k.standard);
  for (const auto& [effect, sum] : sums)
    keys_->push_back({path_, fmt::format("{} from number {} on", key, mostRecorded), "", "",
                      fmt::format("checksum {:x}", sum.value), "", effect});
}

bool TableReader::quantity(const toml::node& n, const char* key, const char* unit, const Range& range,
                           double& value) {
  double v = 0;
  bool good = true;
  std::string why;
  if (const auto* f = n.as_floating_point()) {
    v = f->get();
  } else if (const auto* i = n.as_integer()) {
    v = static_cast<double>(i->get());
  } else if (const auto* s = n.as_string()) {
    if (range.orNever && s->get() == "never") return value = never, true;
    if (range.orOff && s->get() == "off") return value = 0, true;
    const Quantity q = parseQuantity(s->get());
    v = q.value;
    good = q.error.empty() && (!q.hasUnit || q.dimension == dimensionOf(unit));
    if (!q.error.empty() && q.error != missingNumber) why = " (" + q.error + ")";
  } else {
    good = false;
  }
  if (!good) {
    refuse(key, n,
           fmt::format("expected {}{}, got {}{}", kindOfUnit(unit), rangeWords(range), shown(n), why));
    return false;
  }
  if (!std::isfinite(v)) {
    refuse(key, n, fmt::format("must be a finite number, got {}", shown(n)));
    return false;
  }
  if (!holds(range, v)) {
    refuse(key, n, fmt::format("must be {}, got {}", withUnit(rangeRequirement(range), unit), shown(n)));
    return false;
  }
  return value = v, true;
}

void TableReader::checkNumber(const char* key, const char* unit, const Range& range, double value) {
  if (!check_) return;
  if (describing()) check_->defaults.emplace(key, value);
  const bool word = (range.orNever && value == never) || (range.orOff && value == 0);
  const bool standard = !std::isnan(value) && check_->defaults.count({key, value}) > 0;
  if (!recording() || word || standard) return;
  if (!std::isfinite(value))
    check_->errors.push_back({where_, fmt::format("{}: must be a finite number, got {}", named(key), value)});
  else if (!holds(range, value))
    check_->errors.push_back({where_, fmt::format("{}: must be {}, got {}", named(key),
                                                  withUnit(rangeRequirement(range), unit), value)});
}

/// Throws std::invalid_argument at once, since the number is an index.
void TableReader::checkWord(const char* key, int value, const std::vector<std::string>& words) {
  if (value >= 0 && static_cast<std::size_t>(value) < words.size()) return;
  throw std::invalid_argument(
      fmt::format("{}: expected one of {}, got number {}", named(key), listOf(words), value));
}

void TableReader::number(const char* key, double& value, const char* unit, const Range& range,
                         const char* about) {
  checkNumber(key, unit, range, value);
  describe({"", key, unit, rangeText(range), numberText(value), about}, {KeyForm::Type::Quantity, range});
  if (const toml::node* n = get(key)) quantity(*n, key, unit, range, value);
}
void TableReader::number(const char* key, std::optional<double>& value, const char* unit, const Range& range,
                         const char* about) {
  if (value) checkNumber(key, unit, range, *value);
  describe({"", key, unit, rangeText(range), value ? numberText(*value) : "none", about},
           {KeyForm::Type::Quantity, range});
  double v = 0;
  if (const toml::node* n = get(key); n && quantity(*n, key, unit, range, v)) value = v;
}

void TableReader::whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high,
                        const char* about) {
  checkNumber(key, "", between(static_cast<double>(low), static_cast<double>(high)),
              static_cast<double>(value));
  describe({"", key, "", fmt::format("{} ... {}, whole", low, high), fmt::format("{}", value), about},
           {KeyForm::Type::Whole, between(static_cast<double>(low), static_cast<double>(high))});
  const toml::node* n = get(key);
  if (!n) return;
  const auto* i = n->as_integer();
  if (!i || i->get() < low || i->get() > high)
    return refuse(key, *n,
                  fmt::format("expected a whole number from {} to {}, got {}", low, high, shown(*n)));
  value = i->get();
}

/// Reads three quantities. Returns whether the key is there.
bool TableReader::readVector(const char* key, const char* unit, Vec3d& value) {
  const toml::node* n = get(key);
  if (!n) return false;
  const toml::array* a = n->as_array();
  if (!a || a->size() != 3) {
    refuse(key, *n,
           fmt::format("expected a list of three quantities such as [0, 0, 0], got {}",
                       a ? fmt::format("a list of {}", a->size()) : shown(*n)));
    return true;
  }
  for (std::size_t k = 0; k < 3; k++)
    quantity(*a->get(k), key, unit, anyNumber(), value[static_cast<int>(k)]);
  return true;
}
void TableReader::vector(const char* key, Vec3d& value, const char* unit, const char* about) {
  for (int a = 0; a < 3; a++) checkNumber(key, unit, anyNumber(), value[a]);
  describe({"", key, unit, "three numbers", vectorText(value), about}, {KeyForm::Type::Vector});
  readVector(key, unit, value);
}
void TableReader::vector(const char* key, std::optional<Vec3d>& value, const char* unit, const char* about) {
  for (int a = 0; value && a < 3; a++) checkNumber(key, unit, anyNumber(), (*value)[a]);
  describe({"", key, unit, "three numbers", value ? vectorText(*value) : "none", about},
           {KeyForm::Type::Vector});
  Vec3d v{};
  if (readVector(key, unit, v)) value = v;
}

void TableReader::flag(const char* key, bool& value, const char* about) {
  describe({"", key, "", "true, false", value ? "true" : "false", about}, {KeyForm::Type::Flag});
  const toml::node* n = get(key);
  if (!n) return;
  if (const auto* b = n->as_boolean()) value = b->get();
  else refuse(key, *n, "expected true or false, got " + shown(*n));
}

void TableReader::text(const char* key, std::string& value, const char* about, const char* range) {
  describe({"", key, "", range, value.empty() ? "none" : "\"" + value + "\"", about}, {KeyForm::Type::Text});
  const toml::node* n = get(key);
  if (!n) return;
  if (const auto* s = n->as_string()) value = s->get();
  else refuse(key, *n, "expected a text in quotes, got " + shown(*n));
}

void TableReader::words(const char* key, std::vector<std::string>& value,
                        const std::vector<std::string>& allowed, const char* about) {
  describe({"", key, "", "list of " + listOf(allowed), "[" + listOf(value) + "]", about},
           {KeyForm::Type::Words, {}, allowed});
  const toml::node* n = get(key);
  if (!n) return;
  const toml::array* a = n->as_array();
  if (!a) return refuse(key, *n, "expected a list of texts, got " + shown(*n));
  value.clear();
  for (const toml::node& e : *a) {
    const auto* s = e.as_string();
    if (s && std::find(allowed.begin(), allowed.end(), s->get()) != allowed.end()) value.push_back(s->get());
    else if (s)
      refuse(key, e,
             fmt::format("unknown {0}; expected any of {2}{1}", quoted(s->get()),
                         suggestion(s->get(), {allowed.begin(), allowed.end()}), listOf(allowed)));
    else refuse(key, e, "expected a text in quotes, got " + shown(e));
  }
}

void TableReader::choice(const char* key, int& value, const std::vector<std::string>& words,
                         const char* about) {
  checkWord(key, value, words);
  describe({"", key, "", listOf(words), "\"" + words.at(static_cast<std::size_t>(value)) + "\"", about},
           {KeyForm::Type::Choice, {}, words});
  const toml::node* n = get(key);
  if (!n) return;
  const auto* s = n->as_string();
  const auto at = s ? std::find(words.begin(), words.end(), s->get()) : words.end();
  if (at == words.end())
    return refuse(
        key, *n,
        fmt::format("expected {}{}, got {}", words.size() == 2 ? "" : "one of ",
                    words.size() == 2 ? "\"" + words[0] + "\" or \"" + words[1] + "\"" : listOf(words),
                    shown(*n)));
  value = static_cast<int>(at - words.begin());
}

void TableReader::blend(const BlendKey& k, Blend& value) {
  checkNumber(k.key, k.unit, k.range, value.solid);
  checkNumber(k.key, k.unit, k.range, value.liquid);
  const std::string standard = value.solid == value.liquid
                                   ? numberText(value.solid)
                                   : fmt::format("{{ solid = {}, liquid = {} }}", numberText(value.solid),
                                                 numberText(value.liquid));
  describe({"", k.key, k.unit, rangeText(k.range) + ", or { solid = ..., liquid = ... }", standard, k.about},
           {KeyForm::Type::Blend, k.range});
  const toml::node* n = get(k.key);
  if (!n) return;
  if (n->is_table()) {
    const std::size_t before = errors_->size();
    readTable(*n, named(k.key), [&](TableReader& r) {
      r.number("solid", value.solid, k.unit, k.range, "");
      r.number("liquid", value.liquid, k.unit, k.range, "");
    });
    if (errors_->size() > before) refused_.insert(k.key);
  } else if (quantity(*n, k.key, k.unit, k.range, value.solid) && k.liquid == LiquidValue::Same) {
    value.liquid = value.solid;
  }
}

void TableReader::pairs(const PairsKey& k, std::vector<std::pair<double, double>>& value) {
  for (const auto& [first, second] : value) {
    checkNumber(k.key, k.unit1, k.range1, first);
    checkNumber(k.key, k.unit2, k.range2, second);
  }
  std::vector<std::string> texts;
  for (const auto& [first, second] : value)
    texts.push_back(fmt::format("[{}, {}]", numberText(first), numberText(second)));
  describe({"", k.key, "", k.range, listText(texts), k.about}, {KeyForm::Type::Pairs});
  const toml::node* n = get(k.key);
  const toml::array* a = n ? n->as_array() : nullptr;
  if (!n) return;
  const std::string pair = fmt::format("[{}, {}]", *k.unit1 ? k.unit1 : "number",
                                       *k.unit2 ? k.unit2 : "number");
  if (!a || a->size() < 2)
    return refuse(k.key, *n,
                  "expected a list of at least two pairs " + pair + ", such as [[300, 0.5], [400, 0.7]]");
  value.clear();
  for (const toml::node& e : *a) {
    const toml::array* p = e.as_array();
    std::pair<double, double> v;
    if (!p || p->size() != 2) {
      refuse(k.key, e, fmt::format("expected a pair {}, got {}", pair, shown(e)));
      continue;
    }
    const bool first = quantity(*p->get(0), k.key, k.unit1, k.range1, v.first),
               second = quantity(*p->get(1), k.key, k.unit2, k.range2, v.second);
    if (!first || !second) continue;
    if (!value.empty() && v.first <= value.back().first)
      refuse(k.key, e, "the first quantities of the pairs must ascend");
    value.push_back(v);
  }
}

const toml::node* TableReader::node(const char* key, const char* unit, const char* range, const char* about,
                                    const std::string& value) {
  describe({"", key, unit, range, value, about});
  return get(key);
}

void TableReader::readTable(const toml::node& n, const std::string& path,
                            const std::function<void(TableReader&)>& read) {
  const toml::table* t = n.as_table();
  if (!t) return errors_->push_back({placeOfNode(n), path + ": expected a table, got " + shown(n)});
  TableReader r(*t, path, *errors_);
  read(r);
  r.finish();
}

void TableReader::eachTable(const char* key, const char* about,
                            const std::function<void(TableReader&)>& read) {
  describeTable(key, KeyForm::Type::Tables, about);
  if (describing()) {
    TableReader r = inner(named(key), *keys_);
    return read(r);
  }
  const toml::node* n = get(key);
  if (!n) return;
  const auto nameOf = [&](const toml::node& e, std::size_t k) {
    const toml::table* t = e.as_table();
    const auto* s = t ? t->get_as<std::string>("name") : nullptr;
    return named(key) + "." + (s && !s->get().empty() ? s->get() : fmt::format("{}", k));
  };
  if (n->is_table()) return readTable(*n, nameOf(*n, 0), read);
  const toml::array* a = n->as_array();
  if (!a) return refuse(key, *n, "expected a table or a list of tables, got " + shown(*n));
  std::size_t k = 0;
  for (const toml::node& e : *a) {
    readTable(e, nameOf(e, k), read);
    k++;
  }
}

void TableReader::table(const char* key, const char* about, bool there,
                        const std::function<void(TableReader&)>& read) {
  if (recording() && there && once_) keys_->push_back({path_, key, "", "", "true", "", once_});
  describeTable(key, KeyForm::Type::Table, about);
  if (!reading()) {
    TableReader r = inner(named(key), *keys_);
    if (describing() || there) read(r);
  } else if (const toml::node* n = get(key)) {
    readTable(*n, named(key), read);
  }
}
void TableReader::table(const char* key, const char* about, const std::function<void(TableReader&)>& read) {
  table(key, about, true, read);
}

void TableReader::eachNamedTable(const char* key, const char* about,
                                 const std::function<void(const std::string&, TableReader&)>& read) {
  describeTable(key, KeyForm::Type::NamedTables, about);
  if (describing()) {
    TableReader r = inner(named(key) + ".NAME", *keys_);
    return read("NAME", r);
  }
  const toml::node* n = get(key);
  if (!n) return;
  const toml::table* t = n->as_table();
  if (!t) return refuse(key, *n, fmt::format("expected tables such as [{}.NAME], got {}", key, shown(*n)));
  for (const auto& [name, node] : *t) {
    const std::string word(name.str());
    if (!node.is_table()) refused_.insert(key);
    readTable(node, named(key) + "." + word, [&](TableReader& r) { read(word, r); });
  }
}

std::vector<SourcePlace> TableReader::placesOfTable() const {
  std::vector<SourcePlace> places{place()};
  for (const auto& [key, where] : placesOfKeys()) places.push_back(where);
  return places;
}

namespace {

/// Returns a similar key, or all keys of a table that has few.
std::string hintFor(const std::string& name, const std::set<std::string>& known) {
  constexpr std::size_t few = 6;
  const std::string similar = suggestion(name, known);
  if (!similar.empty() || known.empty() || known.size() > few) return similar;
  return fmt::format("; expected {}`{}`", known.size() > 1 ? "one of " : "", fmt::join(known, "`, `"));
}

}  // namespace

void TableReader::finish() {
  if (!table_) return;
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (known_.count(name)) continue;
    const toml::source_region& s = key.source();
    const SourcePlace where = s.path ? SourcePlace{*s.path, static_cast<int>(s.begin.line),
                                                   static_cast<int>(s.begin.column)}
                                     : placeOfNode(node);
    const std::string renamed = renamedKey(name, known_);
    errors_->push_back({where,
                        fmt::format("unknown key '{}'{}{}", name, path_.empty() ? "" : " in " + path_,
                                    renamed.empty() ? hintFor(name, known_)
                                                    : fmt::format("; its new name is '{}'", renamed)),
                        SceneError::Kind::UnknownKey, path_, placesOfTable(),
                        renamed.empty() ? nearestWord(name, known_) : renamed});
  }
}

}  // namespace thaw
