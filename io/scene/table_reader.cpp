#include "io/scene/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/scene/units.hpp"

namespace thaw {
namespace {

std::string numberText(double v) { return v == never ? "never" : v == -never ? "-never" : fmt::format("{}", v); }

/// What a quantity of a unit is called in messages.
std::string kindOf(const std::string& unit) {
  if (unit.empty() || unit == "1") return "a number";
  return fmt::format("a quantity in {} such as \"1 {}\"", unit, unit == "K" ? "K" : unit);
}

std::string shown(const toml::node& n) {
  if (const auto* s = n.as_string()) return "\"" + s->get().substr(0, 60) + "\"";
  if (const auto* i = n.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = n.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = n.as_boolean()) return b->get() ? "true" : "false";
  return n.is_array() ? "a list" : n.is_table() ? "a table" : "a date or time";
}

}  // namespace

std::string Range::text() const {
  if (low == -never && high == never) return "";
  if (high == never) return fmt::format("{} {}", openLow ? ">" : ">=", numberText(low));
  if (low == -never) return fmt::format("{} {}", openHigh ? "<" : "<=", numberText(high));
  return fmt::format("{}{} ... {}{}", openLow ? "> " : "", numberText(low), openHigh ? "< " : "", numberText(high));
}

SourcePlace placeOfNode(const toml::node& n) {
  const toml::source_region& s = n.source();
  return {s.path ? *s.path : std::string("--set"), static_cast<int>(s.begin.line), static_cast<int>(s.begin.column)};
}

std::string nearestWord(const std::string& word, const std::set<std::string>& words) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& w : words) {  // Levenshtein distance
    std::vector<std::size_t> row(w.size() + 1);
    for (std::size_t k = 0; k <= w.size(); k++) row[k] = k;
    for (std::size_t i = 1; i <= word.size(); i++) {
      std::size_t corner = row[0];
      row[0] = i;
      for (std::size_t k = 1; k <= w.size(); k++) {
        const std::size_t swap = corner + (word[i - 1] != w[k - 1]);
        corner = row[k];
        row[k] = std::min({swap, row[k] + 1, row[k - 1] + 1});
      }
    }
    if (row[w.size()] < least) least = row[w.size()], best = w;
  }
  return best;
}

TableReader::TableReader(const toml::table& table, std::string path, std::vector<SceneError>& errors) : table_(&table), path_(std::move(path)), errors_(&errors) {}
TableReader::TableReader(std::string path, std::vector<KeyDescription>& descriptions) : path_(std::move(path)), descriptions_(&descriptions) {}

SourcePlace TableReader::place() const { return table_ ? placeOfNode(*table_) : SourcePlace{}; }
SourcePlace TableReader::placeOf(const char* key) const {
  const toml::node* n = table_ ? table_->get(key) : nullptr;
  return n ? placeOfNode(*n) : place();
}
void TableReader::fail(const SourcePlace& where, const std::string& text) {
  if (errors_) errors_->push_back({where, text});
}
void TableReader::fail(const char* key, const std::string& text) {
  fail(placeOf(key), fmt::format("{}{}{}: {}", path_, path_.empty() ? "" : ".", key, text));
}

const toml::node* TableReader::get(const char* key) {
  known_.insert(key);
  return table_ ? table_->get(key) : nullptr;
}

void TableReader::describe(const char* key, const std::string& unit, const std::string& range, const std::string& standard, const char* about) {
  known_.insert(key);
  if (descriptions_) descriptions_->push_back({path_, key, unit, range, standard, about});
}

bool TableReader::quantity(const toml::node& n, const char* key, const char* unit, const Range& range, double& value) {
  double v = 0;
  if (const auto* f = n.as_floating_point()) {
    v = f->get();
  } else if (const auto* i = n.as_integer()) {
    v = static_cast<double>(i->get());
  } else if (const auto* s = n.as_string(); s && s->get() == "never" && range.high == never) {
    value = never;
    return true;
  } else if (s) {
    const Quantity q = parseQuantity(s->get());
    const Dimension wanted = dimensionOf(unit);
    if (!q.error.empty() || (q.hasUnit && q.dimension != wanted)) {
      fail(placeOfNode(n), fmt::format("{}{}{}: expected {}, got {}{}", path_, path_.empty() ? "" : ".", key, kindOf(unit), shown(n), q.error.empty() ? "" : " (" + q.error + ")"));
      return false;
    }
    v = q.value;
  } else {
    fail(placeOfNode(n), fmt::format("{}{}{}: expected {}, got {}", path_, path_.empty() ? "" : ".", key, kindOf(unit), shown(n)));
    return false;
  }
  const bool inside = std::isfinite(v) && (range.openLow ? v > range.low : v >= range.low) && (range.openHigh ? v < range.high : v <= range.high);
  if (!inside) {
    const std::string allowed = range.text();
    fail(placeOfNode(n), fmt::format("{}{}{}: must be {}{}, got {}", path_, path_.empty() ? "" : ".", key, allowed.empty() ? "a finite number" : allowed,
                                     unit[0] && std::string(unit) != "1" && !allowed.empty() ? std::string(" ") + unit : "", shown(n)));
    return false;
  }
  value = v;
  return true;
}

void TableReader::number(const char* key, double& value, const char* unit, const Range& range, const char* about) {
  describe(key, unit, range.text(), numberText(value), about);
  if (const toml::node* n = get(key)) quantity(*n, key, unit, range, value);
}
void TableReader::number(const char* key, std::optional<double>& value, const char* unit, const Range& range, const char* about) {
  describe(key, unit, range.text(), "none", about);
  double v = 0;
  if (const toml::node* n = get(key); n && quantity(*n, key, unit, range, v)) value = v;
}

void TableReader::whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high, const char* about) {
  describe(key, "", fmt::format("{} ... {}", low, high), fmt::format("{}", value), about);
  const toml::node* n = get(key);
  if (!n) return;
  const auto* i = n->as_integer();
  if (!i || i->get() < low || i->get() > high) return fail(key, fmt::format("expected a whole number from {} to {}, got {}", low, high, shown(*n)));
  value = i->get();
}

void TableReader::vector(const char* key, Vec3d& value, const char* unit, const char* about) {
  describe(key, unit, "three numbers", fmt::format("[{}, {}, {}]", value.x, value.y, value.z), about);
  const toml::node* n = get(key);
  if (!n) return;
  const toml::array* a = n->as_array();
  if (!a || a->size() != 3) return fail(key, fmt::format("expected three quantities such as [0, 0, 0], got {}", shown(*n)));
  for (std::size_t k = 0; k < 3; k++) quantity(*a->get(k), key, unit, anyNumber(), value[static_cast<int>(k)]);
}
void TableReader::vector(const char* key, std::optional<Vec3d>& value, const char* unit, const char* about) {
  if (describing() || has(key)) {
    Vec3d v{};
    vector(key, v, unit, about);
    if (descriptions_) descriptions_->back().standard = "none";
    else value = v;
  }
  known_.insert(key);
}

void TableReader::flag(const char* key, bool& value, const char* about) {
  describe(key, "", "true, false", value ? "true" : "false", about);
  const toml::node* n = get(key);
  if (!n) return;
  if (const auto* b = n->as_boolean()) value = b->get();
  else fail(key, "expected true or false, got " + shown(*n));
}

void TableReader::text(const char* key, std::string& value, const char* about) {
  describe(key, "", "text", value.empty() ? "none" : "\"" + value + "\"", about);
  const toml::node* n = get(key);
  if (!n) return;
  if (const auto* s = n->as_string()) value = s->get();
  else fail(key, "expected a text in quotes, got " + shown(*n));
}

void TableReader::texts(const char* key, std::vector<std::string>& value, const char* about) {
  std::string standard;
  for (const std::string& v : value) standard += (standard.empty() ? "[\"" : ", \"") + v + "\"";
  describe(key, "", "list of texts", standard.empty() ? "none" : standard + "]", about);
  const toml::node* n = get(key);
  if (!n) return;
  const toml::array* a = n->as_array();
  if (!a) return fail(key, "expected a list of texts, got " + shown(*n));
  value.clear();
  for (const toml::node& e : *a) {
    if (const auto* s = e.as_string()) value.push_back(s->get());
    else fail(placeOfNode(e), fmt::format("{}.{}: expected a text in quotes, got {}", path_, key, shown(e)));
  }
}

void TableReader::choice(const char* key, int& value, const std::vector<std::string>& words, const char* about) {
  std::string all;
  for (const std::string& w : words) all += (all.empty() ? "\"" : ", \"") + w + "\"";
  describe(key, "", all, "\"" + words[static_cast<std::size_t>(value)] + "\"", about);
  const toml::node* n = get(key);
  if (!n) return;
  const auto* s = n->as_string();
  const auto at = s ? std::find(words.begin(), words.end(), s->get()) : words.end();
  if (at == words.end()) return fail(key, fmt::format("expected one of {}, got {}", all, shown(*n)));
  value = static_cast<int>(at - words.begin());
}

void TableReader::blend(const char* key, Blend& value, const char* unit, const Range& range, bool liquidToo, const char* about) {
  const std::string standard = value.solid == value.liquid ? numberText(value.solid) : fmt::format("{{ solid = {}, liquid = {} }}", numberText(value.solid), numberText(value.liquid));
  describe(key, unit, range.text(), standard, about);
  const toml::node* n = get(key);
  if (!n) return;
  if (const toml::table* t = n->as_table()) {
    TableReader r(*t, path_ + "." + key, *errors_);
    r.number("solid", value.solid, unit, range, "");
    r.number("liquid", value.liquid, unit, range, "");
    r.finish();
  } else if (quantity(*n, key, unit, range, value.solid) && liquidToo) {
    value.liquid = value.solid;
  }
}

void TableReader::pairs(const char* key, std::vector<std::pair<double, double>>& value, const char* unit1, const char* unit2, const Range& range2, const char* about) {
  describe(key, fmt::format("{}, {}", unit1, unit2), "list of pairs", "none", about);
  const toml::node* n = get(key);
  if (!n) return;
  const toml::array* a = n->as_array();
  if (!a || a->empty()) return fail(key, "expected a list of pairs, got " + shown(*n));
  value.clear();
  for (const toml::node& e : *a) {
    const toml::array* p = e.as_array();
    std::pair<double, double> v;
    if (!p || p->size() != 2) fail(placeOfNode(e), fmt::format("{}.{}: expected a pair [{}, {}], got {}", path_, key, unit1, unit2, shown(e)));
    else if (quantity(*p->get(0), key, unit1, anyNumber(), v.first) && quantity(*p->get(1), key, unit2, range2, v.second)) {
      if (!value.empty() && v.first <= value.back().first) fail(placeOfNode(e), fmt::format("{}.{}: the first numbers of the pairs must ascend", path_, key));
      value.push_back(v);
    }
  }
}

const toml::node* TableReader::node(const char* key, const char* kind, const char* about) {
  describe(key, "", kind, "none", about);
  return get(key);
}

void TableReader::tables(const char* key, const char* about, const std::function<void(TableReader&)>& read) {
  const std::string name = path_.empty() ? key : path_ + "." + key;
  if (descriptions_) {
    describe(key, "", "list of tables", "none", about);
    TableReader r(name, *descriptions_);
    return read(r);
  }
  const toml::node* n = get(key);
  if (!n) return;
  if (const toml::table* t = n->as_table()) {
    TableReader r(*t, name, *errors_);
    read(r);
    r.finish();
  } else if (const toml::array* a = n->as_array()) {
    std::size_t k = 0;
    for (const toml::node& e : *a) {
      if (const toml::table* t = e.as_table()) {
        TableReader r(*t, fmt::format("{}[{}]", name, k), *errors_);
        read(r);
        r.finish();
      } else {
        fail(placeOfNode(e), name + ": expected a table, got " + shown(e));
      }
      k++;
    }
  } else {
    fail(key, "expected a table or a list of tables, got " + shown(*n));
  }
}

void TableReader::table(const char* key, const char* about, const std::function<void(TableReader&)>& read) {
  const std::string name = path_.empty() ? key : path_ + "." + key;
  if (descriptions_) {
    describe(key, "", "table", "none", about);
    TableReader r(name, *descriptions_);
    return read(r);
  }
  const toml::node* n = get(key);
  if (!n) return;
  const toml::table* t = n->as_table();
  if (!t) return fail(key, "expected a table, got " + shown(*n));
  TableReader r(*t, name, *errors_);
  read(r);
  r.finish();
}

void TableReader::namedTable(const toml::node& n, const std::string& path, const std::function<void(TableReader&)>& read) {
  const toml::table* t = n.as_table();
  if (!t) return fail(placeOfNode(n), path + ": expected a table, got " + shown(n));
  TableReader r(*t, path, *errors_);
  read(r);
  r.finish();
}

void TableReader::finish() {
  if (!table_) return;
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (known_.count(name)) continue;
    const std::string near = nearestWord(name, known_);
    const toml::source_region& s = key.source();
    const SourcePlace where = s.path ? SourcePlace{*s.path, static_cast<int>(s.begin.line), static_cast<int>(s.begin.column)} : placeOfNode(node);
    fail(where, fmt::format("unknown key '{}'{}{}", name, path_.empty() ? "" : " in " + path_, near.empty() ? "" : "; did you mean '" + near + "'?"));
  }
}

}  // namespace thaw
