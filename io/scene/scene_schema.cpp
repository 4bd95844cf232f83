// SPDX-License-Identifier: Apache-2.0
// The JSON schema of scene files, from the table of keys. Draft 4 is the one that editors of TOML read.
#include <cmath>
#include <map>
#include <stdexcept>

#include <toml++/toml.h>
#include <nlohmann/json.hpp>

#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;
using Type = KeyForm::Type;

constexpr const char* shapeTable = "SHAPE";
// The begin of a number. Units are checked by the reader alone.
constexpr const char* numberPattern = "\\s*[-+]?\\.?[0-9]";

Json typed(const char* type) { return {{"type", type}}; }

/// A value of any of these forms, which have different types. Each keyword concerns values of one type, so an
/// editor's message names the one that fails.
Json either(const std::vector<Json>& forms) {
  Json to{{"type", Json::array()}};
  for (Json form : forms) {
    const Json types = form["type"];
    if (types.is_array()) to["type"].insert(to["type"].end(), types.begin(), types.end());
    else to["type"].push_back(types);
    form.erase("type");
    to.update(form);
  }
  return to;
}

Json listOfForms(const Json& item, std::size_t least = 0, std::size_t most = 0) {
  Json list{{"type", "array"}, {"items", item}};
  if (least > 0) list["minItems"] = least;
  if (most > 0) list["maxItems"] = most;
  return list;
}

/// A number within the range, or a text that begins with a number.
Json quantityForm(const Range& range) {
  Json to{{"type", {"number", "string"}}};
  if (std::isfinite(range.low)) {
    to["minimum"] = range.low;
    if (range.openLow) to["exclusiveMinimum"] = true;
  }
  if (std::isfinite(range.high)) {
    to["maximum"] = range.high;
    if (range.openHigh) to["exclusiveMaximum"] = true;
  }
  const std::string pattern = numberPattern;
  to["pattern"] = range.orNever ? "^(" + pattern + "|never$)" : "^" + pattern;
  return to;
}

Json closedTable(Json properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json pairsForm() { return listOfForms(listOfForms(quantityForm({}), 2, 2), 2); }
Json vectorForm() { return listOfForms(quantityForm({}), 3, 3); }

/// A table of numbers or expressions of position.
Json componentsForm() {
  const Json one{{"type", {"number", "string"}}};
  return closedTable({{"x", one}, {"y", one}, {"z", one}});
}

Json reference(const std::string& table) { return {{"$ref", "#/definitions/" + table}}; }

/// A list of tables. The reader takes a single table for a list of one. Definitions of tables concern objects
/// alone, and so hold for lists.
Json tablesForm(const std::string& table) {
  return {{"type", {"array", "object"}},
          {"items", {{"type", "object"}, {"allOf", Json::array({reference(table)})}}},
          {"allOf", Json::array({reference(table)})}};
}

/// Forms of keys that describe their values by a text alone.
Json formOfText(const KeyDescription& k) {
  const Json text = typed("string"), temperature = quantityForm(positive());
  const Json side{{"enum", {"open", "wall", "periodic"}}};
  const Json pair{{"anyOf", Json::array({side, listOfForms(side, 2, 2)})}};
  const std::map<std::string, Json> forms{
      {"path or list of paths", either({text, listOfForms(text)})},
      {"list of tables with a SHAPE each", tablesForm(shapeTable)},
      {"list of [x, y, z]", listOfForms(vectorForm())},
      {"three lists of three numbers", listOfForms(vectorForm(), 3, 3)},
      {"table of expressions x, y, z", componentsForm()},
      {"\"open\", \"wall\", \"periodic\" or a pair [low, high]", pair},
      {"> 0, one temperature or [solidus, liquidus]", either({temperature, listOfForms(temperature, 2, 2)})}};
  const auto found = forms.find(k.range);
  if (found == forms.end())
    throw std::logic_error(k.table + "." + k.key + ": the schema has no form for values of: " + k.range);
  return found->second;
}

class SchemaWriter {
 public:
  SchemaWriter() : keys_(sceneKeys()) {}

  Json document() {
    Json schema{{"$schema", "http://json-schema.org/draft-04/schema#"},
                {"title", "Scene of thaw"},
                {"description", "Keys of a scene file. Made by: thaw docs --schema"}};
    schema.update(tableForm(""));
    schema["properties"]["wall"] = schema["properties"]["obstacle"];
    schema["properties"]["wall"]["description"] = "the same as obstacle";
    define(shapeTable);
    schema["definitions"] = std::move(definitions_);
    return schema;
  }

 private:
  Json tableForm(const std::string& path) {
    Json properties = propertiesOf(path);
    // Only the program that reads the scene knows the keys of its extensions.
    return properties.empty() ? typed("object") : closedTable(std::move(properties));
  }

  /// Adds the keys of a table to the definitions. Returns its name.
  std::string define(const std::string& path) {
    Json table = tableForm(path);
    table.erase("type");
    definitions_[path] = std::move(table);
    return path;
  }

  Json propertiesOf(const std::string& path) {
    Json properties = Json::object();
    for (const KeyDescription& k : keys_) {
      if (k.table != path || (path.empty() && k.key == shapeTable)) continue;
      if (k.key == shapeTable) {
        for (const KeyDescription& s : keys_)
          if (s.table == shapeTable) properties[s.key] = reference("SHAPE/properties/" + s.key);
      } else {
        properties[k.key] = property(k);
      }
    }
    return properties;
  }

  static std::string inner(const KeyDescription& k) {
    return k.table.empty() ? k.key : k.table + "." + k.key;
  }

  static bool isTable(const KeyDescription& k) {
    return k.form.type == Type::Table || k.form.type == Type::Tables || k.form.type == Type::NamedTables;
  }

  Json property(const KeyDescription& k) {
    Json to{{"description", description(k)}};
    to.update(k.form.alternative ? either({form(k), alternative(k)}) : form(k));
    if (k.standard != "none") to["default"] = defaultOf(k.standard);
    return to;
  }

  /// Returns the meaning, and unit and range where the form does not show them.
  static std::string description(const KeyDescription& k) {
    std::string values = k.unit.empty() ? "" : "unit: " + k.unit;
    if (!isTable(k)) values += (values.empty() ? "" : "; ") + k.range;
    return values.empty() || k.about.empty() ? k.about + values : k.about + "\n\n" + values;
  }

  static Json alternative(const KeyDescription& k) {
    if (*k.form.alternative == Type::Pairs) return pairsForm();
    // A text with an expression is a text, which the number's pattern would refuse.
    return k.form.type == Type::Vector ? componentsForm() : Json{{"type", Json::array()}, {"pattern", ""}};
  }

  Json form(const KeyDescription& k) {
    switch (k.form.type) {
      case Type::Quantity: return quantityForm(k.form.range);
      case Type::Blend: {
        const Json one = quantityForm(k.form.range);
        return either({one, closedTable({{"solid", one}, {"liquid", one}})});
      }
      case Type::Whole: return wholeForm(k.form.range);
      case Type::Vector: return vectorForm();
      case Type::Flag: return typed("boolean");
      case Type::Text:
        if (k.range == "\"#rrggbb\"") return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
        return typed("string");
      case Type::Words: return listOfForms({{"enum", k.form.words}});
      case Type::Choice: return {{"enum", k.form.words}};
      case Type::Pairs: return pairsForm();
      case Type::Table: return tableForm(inner(k));
      case Type::Tables: return tablesForm(define(inner(k)));
      case Type::NamedTables:
        return {{"type", "object"}, {"additionalProperties", tableForm(inner(k) + ".NAME")}};
      case Type::Expression:
      case Type::Other: break;
    }
    return formOfText(k);
  }

  static Json wholeForm(const Range& range) {
    Json number{{"type", "integer"}, {"minimum", static_cast<std::int64_t>(range.low)}};
    constexpr double exact = 9007199254740992;  // larger limits are not numbers of JSON
    if (range.high <= exact) number["maximum"] = static_cast<std::int64_t>(range.high);
    return number;
  }

  static Json defaultOf(const std::string& value) {
    const toml::table table = toml::parse("value = " + value);
    return toJson(*table.get("value"));
  }

  static Json toJson(const toml::node& n) {
    if (const auto* t = n.as_table()) {
      Json object = Json::object();
      for (const auto& [key, node] : *t) object[std::string(key.str())] = toJson(node);
      return object;
    }
    if (const auto* a = n.as_array()) {
      Json list = Json::array();
      for (const toml::node& e : *a) list.push_back(toJson(e));
      return list;
    }
    if (const auto* s = n.as_string()) return s->get();
    if (const auto* b = n.as_boolean()) return b->get();
    if (const auto* i = n.as_integer()) return i->get();
    return n.as_floating_point()->get();
  }

  std::vector<KeyDescription> keys_;
  Json definitions_ = Json::object();
};

}  // namespace

std::string sceneSchema() { return SchemaWriter().document().dump(1) + "\n"; }

}  // namespace thaw
