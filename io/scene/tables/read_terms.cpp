// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

#include "core/terms/extensions.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {
namespace {

/// An element of a list of tables: a place in Scene's own list.
struct TermRow {
  std::string name = {};
  SourcePlace where = {};
  std::size_t index = 0;
};

/// The keys of a table as a term declares them.
class TermKeys : public KeyTable {
 public:
  explicit TermKeys(TableReader& reader) : r_(reader) {}
  TermKeys(TableReader& reader, SceneReading& reading, const TermTable& table, std::size_t index)
      : r_(reader), reading_(&reading), table_(&table), index_(index) {}

  bool reading() const override { return r_.reading(); }
  bool recording() const override { return r_.recording(); }
  bool has(const char* key) const override { return r_.has(key); }
  bool refused(const char* key) const override { return r_.refused(key); }
  std::string textOf(const char* key) const override { return r_.textOf(key); }
  void fail(const char* key, const std::string& text, std::initializer_list<const char*> others) override {
    r_.fail(key, text, others);
  }
  void restart(Restart effect) override { r_.restart(effect); }
  KeyTable& as(Restart effect) override { return r_.as(effect), *this; }
  KeyTable& defaultAs(const char* words) override { return r_.defaultAs(words), *this; }
  KeyTable& byScene() override { return r_.byScene(), *this; }
  KeyTable& needed() override { return r_.needed(), *this; }
  void number(const char* key, double& value, const char* unit, const Range& range,
              const char* about) override {
    r_.number(key, value, unit, range, about);
  }
  void whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high,
             const char* about) override {
    r_.whole(key, value, low, high, about);
  }
  void flag(const char* key, bool& value, const char* about) override { r_.flag(key, value, about); }
  void blend(const BlendKey& key, Blend& value) override { r_.blend(key, value); }
  void byTemperature(const char* key, double& value, TemperatureTable& table, const char* unit,
                     const Range& range, const char* about) override {
    if (r_.hasList(key) || !table.empty()) pairs({key, unit, positive(), ""}, table);
    else r_.orAs(KeyForm::Type::Pairs).number(key, value, unit, range, about);
  }
  void byTemperature(const BlendKey& key, Blend& value, TemperatureTable& table) override {
    if (r_.hasList(key.key) || !table.empty()) pairs({key.key, key.unit, positive(), ""}, table);
    else r_.orAs(KeyForm::Type::Pairs).blend(key, value);
  }
  void byTemperature(const QuantityKey& key, TemperatureTable& table) override {
    if (r_.hasList(key.key) || table.size() > 1) return pairs(key, table);
    std::optional<double> value;
    if (!table.empty()) value = table.front().second;
    r_.orAs(KeyForm::Type::Pairs).number(key.key, value, key.unit, key.range, key.about);
    if (value) table = {{0, *value}};
  }
  void vector(const char* key, Vec3d& value, const char* unit, const char* about) override {
    r_.vector(key, value, unit, about);
  }
  void choice(const char* key, int& value, const std::vector<std::string>& words,
              const char* about) override {
    r_.choice(key, value, words, about);
  }
  void table(const char* key, const char* about, bool there,
             const std::function<void(KeyTable&)>& read) override {
    r_.table(key, about, there, [&](TableReader& inner) {
      TermKeys keys(inner);
      read(keys);
    });
  }
  void name(std::string& value) override {
    const std::string about = std::string("for messages and `--set`; none: \"") + table_->title +
                              "\" and its number";
    r_.as(Restart::Free).text("name", value, about.c_str());
    if (r_.reading() && value.empty()) value = table_->title + (" " + std::to_string(index_));
  }
  void shape(Shape& value) override { readShape(r_, value); }
  void motion(std::vector<Keyframe>& value, const char* about) override { readMotion(r_, about, value); }
  void material(int& value, const char* about) override {
    std::vector<MaterialName> names;
    readMaterialName(r_, *reading_, value, names, about);
    for (MaterialName& name : names) reading_->termMaterials.push_back({std::move(name), table_, index_});
  }

 private:
  void pairs(const QuantityKey& key, TemperatureTable& table) {
    r_.pairs({key.key, "K", key.unit, {0, never, true, false, false}, key.range, "", key.about}, table);
  }

  TableReader& r_;
  SceneReading* reading_ = nullptr;
  const TermTable* table_ = nullptr;
  std::size_t index_ = 0;
};

void readTable(TableReader& top, SceneReading& x, const TermTable& table) {
  Scene& s = *x.scene;
  std::vector<TermRow> rows;
  for (std::size_t k = 0; top.recording() && k < table.size(s); k++) {
    const TermElement element = table.at(s, k);
    rows.push_back({element.name ? *element.name : "", *element.where, k});
  }
  top.tables(table.key, table.about, rows, [&](TableReader& r, TermRow& row) {
    if (!r.recording()) {
      row.index = table.size(s);
      table.append(s);
      *table.at(s, row.index).where = row.where;
    }
    TermKeys keys(r, x, table, row.index);
    table.keys(keys, s, row.index);
    if (r.describing()) table.removeLast(s);
  });
}

}  // namespace

void readTermTables(TableReader& top, SceneReading& x) {
  for (const Extension* term : modelTerms())
    for (const TermTable& table : term->model->tables) readTable(top, x, table);
}

void readTermKeys(TableReader& r, Domain& domain) {
  TermKeys keys(r);
  for (const Extension* term : modelTerms())
    if (term->model->domainKeys) term->model->domainKeys(keys, domain);
}

void readTermKeys(TableReader& r, Numerics& numerics) {
  TermKeys keys(r);
  for (const Extension* term : modelTerms())
    if (term->model->numericsKeys) term->model->numericsKeys(keys, numerics);
}

void checkTermKeys(TableReader& r, const Material& material, const Numerics& numerics) {
  TermKeys keys(r);
  for (const Extension* term : modelTerms())
    if (term->model->checkMaterial) term->model->checkMaterial(keys, material, numerics);
}

void readTermKeys(TableReader& r, Material& material, bool heat) {
  TermKeys keys(r);
  for (const Extension* term : modelTerms())
    if (term->heats == heat && term->model->materialKeys) term->model->materialKeys(keys, material);
}

std::vector<std::string> keysOf(const ModelPart& term) {
  std::vector<std::string> all;
  for (const TermTable& table : term.tables) all.push_back(std::string("[[") + table.key + "]]");
  std::vector<KeyDescription> keys;
  TableReader inDomain("domain", keys, TableReader::Mode::Describing);
  TableReader inNumerics("numerics", keys, TableReader::Mode::Describing);
  TableReader inMaterial("material.NAME", keys, TableReader::Mode::Describing);
  TermKeys domainKeys(inDomain), numericsKeys(inNumerics), materialKeys(inMaterial);
  Domain domain;
  Numerics numerics;
  Material material;
  if (term.domainKeys) term.domainKeys(domainKeys, domain);
  if (term.numericsKeys) term.numericsKeys(numericsKeys, numerics);
  if (term.materialKeys) term.materialKeys(materialKeys, material);
  for (const KeyDescription& key : keys) all.push_back(key.table + "." + key.key);
  return all;
}

}  // namespace thaw
