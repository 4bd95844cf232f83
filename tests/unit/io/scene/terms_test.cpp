// SPDX-License-Identifier: Apache-2.0
// Properties of all terms of the registry (core/terms/terms.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "core/simulation/time/step_limits.hpp"
#include "core/terms/extensions.hpp"
#include "io/run/ledger_log.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

Scene sceneOf(const std::string& tables) {
  return readScene(sceneFilesOf("terms.toml",
                                "spacing = 0.1\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n"
                                "[material.wax]\nyoung = 1e6\n[[body]]\nname = \"block\"\n"
                                "box = { size = [0.5, 0.5, 0.5] }\nmaterial = \"wax\"\n" +
                                    tables));
}

std::set<std::string> ledgerColumns() {
  const std::string out = ::testing::TempDir() + "terms_test";
  std::filesystem::create_directories(out);
  Modules all;
  all.lamps = all.evaporation = true;
  beginLedgerLog(out, all);
  std::ifstream file(ledgerLogPath(out));
  std::set<std::string> columns;
  for (std::string column; std::getline(file, column, ',');) columns.insert(column);
  std::filesystem::remove_all(out);
  return columns;
}

TEST(Terms, EnergiesAreColumnsOfTheLedger) {
  const std::set<std::string> columns = ledgerColumns();
  for (const Extension* term : modelTerms())
    for (const char* energy : term->model->energies) EXPECT_TRUE(columns.count(energy)) << energy;
}

TEST(Terms, LimitsAreThoseOfTheStep) {
  for (const Extension* term : modelTerms()) {
    const std::vector<const char*>& limits = term->model->limits;
    EXPECT_TRUE(!limits.empty() || !term->model->stepLimit) << term->name;
    for (const std::string_view limit : limits)
      EXPECT_EQ(std::count(limitNames.begin(), limitNames.end(), limit), 1) << term->name;
  }
}

TEST(Terms, KeysBelongToOneTerm) {
  std::set<std::string> keys;
  for (const Extension* term : modelTerms()) {
    EXPECT_FALSE(keysOf(*term->model).empty()) << term->name;
    for (const std::string& key : keysOf(*term->model)) EXPECT_TRUE(keys.insert(key).second) << key;
  }
}

// ---- the registry is complete -----------------------------------------------------------------------------

/// Names without a row, with the reasons.
using Exceptions = std::map<std::string, std::string>;

/// Expects each name to be either declared by a row or an exception.
void expectComplete(const std::set<std::string>& names, const std::set<std::string>& declared,
                    const Exceptions& others) {
  for (const std::string& name : names) {
    EXPECT_TRUE(declared.count(name) || others.count(name)) << name << " is declared by no row";
    EXPECT_FALSE(declared.count(name) && others.count(name)) << name << " is declared by a row";
  }
  for (const auto& [name, why] : others) EXPECT_TRUE(names.count(name)) << name << " does not exist";
}

TEST(Terms, KeysOfMaterialsAreDeclaredByThemOrByLaws) {
  const std::string table = "material.NAME";
  std::set<std::string> names, declared;
  for (const KeyDescription& k : sceneKeys())
    if (k.table == table || k.table.rfind(table + ".", 0) == 0) names.insert(k.table + "." + k.key);
  for (const Extension* term : modelTerms())
    for (const std::string& key : keysOf(*term->model)) declared.insert(key);
  for (const std::string& law : lawNames()) {
    declared.insert(table + "." + law);
    for (const ExtensionKey& key : findExtension(law)->keys)
      declared.insert(table + "." + law + "." + key.name);
  }
  ASSERT_GT(names.size(), 40u);
  expectComplete(names, declared,
                 {{table + ".density", "mass of particles, of all terms"},
                  {table + ".colour", "pictures"},
                  {table + ".law", "chooses an elastic law"},
                  {table + ".phase", "state at the start"},
                  {table + ".heat_capacity", "temperature of all terms that heat"},
                  {table + ".melts", "temperatures of the phases, of all terms that depend on them"}});
}

TEST(Terms, LimitsOfTheStepHaveATerm) {
  std::set<std::string> declared;
  for (const Extension* term : modelTerms())
    declared.insert(term->model->limits.begin(), term->model->limits.end());
  expectComplete({limitNames.begin(), limitNames.end()}, declared,
                 {{"speed", "motion of all particles"},
                  {"scene", "numerics.max_step"},
                  {"extensions", "of programs"},
                  {"oriented particles", "a body type with integrators of its own"},
                  {"sheets", "a body type with an integrator of its own"}});
}

/// Returns the names of the members of Modules that are bool, by their offset.
std::map<std::size_t, std::string> modulesByOffset() {
  std::ifstream file(THAW_SOURCE_DIR "/core/scene/modules.hpp");
  std::ostringstream text;
  text << file.rdbuf();
  std::string body = text.str();
  body = body.substr(body.find("struct Modules {"));
  body = std::regex_replace(body.substr(0, body.find("\n};")), std::regex("//[^\n]*"), "");
  std::map<std::size_t, std::string> names;
  std::size_t offset = 0;
  const std::regex member("(\\w+) = (false|1)");
  for (std::sregex_iterator at(body.begin(), body.end(), member), end; at != end; ++at)
    if ((*at)[2] == "false") {
      names[offset++] = (*at)[1];
    } else {
      EXPECT_EQ((*at)[1], "mostSubsteps");
      offset = offsetof(Modules, mostSubsteps) + sizeof(int);
    }
  EXPECT_LE(offset, offsetof(Modules, why));
  return names;
}

std::size_t offsetOf(bool Modules::*module) {
  const Modules m;
  return static_cast<std::size_t>(reinterpret_cast<const char*>(&(m.*module)) -
                                  reinterpret_cast<const char*>(&m));
}

TEST(Terms, ModulesBelongToATerm) {
  const std::map<std::size_t, std::string> byOffset = modulesByOffset();
  ASSERT_EQ(byOffset.at(offsetOf(&Modules::fluid)), "fluid");
  ASSERT_EQ(byOffset.at(offsetOf(&Modules::sheetContact)), "sheetContact");
  std::set<std::string> names, declared;
  for (const auto& [offset, name] : byOffset) names.insert(name);
  for (const Extension* term : modelTerms())
    for (const TermModule& own : term->model->modules) {
      const std::string& name = byOffset.at(offsetOf(own.module));
      EXPECT_TRUE(declared.insert(name).second) << name << " belongs to two terms";
    }
  const char *bodyType = "a body type of its own", *method = "a numerical method without a law";
  expectComplete(names, declared,
                 {{"fluid", "a phase"},
                  {"rigid", "a phase, and the pieces of rigidify"},
                  {"rareContact", "how contact limits the step"},
                  {"rigidify", method},
                  {"sleep", method},
                  {"pieceSleep", method},
                  {"neighbours", method},
                  {"uniform", method},
                  {"surface", bodyType},
                  {"emitters", "where particles come from"},
                  {"oriented", bodyType},
                  {"orientedContact", bodyType},
                  {"sheet", bodyType},
                  {"sheetContact", bodyType}});
}

TEST(Terms, EnergiesOfTheLedgerHaveATerm) {
  std::set<std::string> names, declared;
  for (const std::string& column : ledgerColumns())
    if (column.size() > 2 && column.compare(column.size() - 2, 2, "_J") == 0) names.insert(column);
  for (const Extension* term : modelTerms())
    declared.insert(term->model->energies.begin(), term->model->energies.end());
  Exceptions others{{"kinetic_J", "motion of all particles"},
                    {"potential_J", "sum of those of terms"},
                    {"restart_jump_J", "changed coefficients at a restart"}};
  for (const char* of : {"energy", "heat"})
    for (const char* what : {"_residual_J", "_scale_J", "_rounding_J"})
      if (names.count(std::string(of) + what)) others[std::string(of) + what] = "balance";
  for (const char* flow : {"entered", "left"})
    for (const char* what : {"_kinetic_J", "_elastic_J", "_potential_J", "_internal_J"})
      others[std::string(flow) + what] = "particles that enter or leave";
  ASSERT_GT(names.size(), 20u);
  expectComplete(names, declared, others);
}

TEST(Terms, SceneWithoutTheirKeysUsesNone) {
  const Scene s = sceneOf("");
  for (const Extension* term : modelTerms()) EXPECT_FALSE(isUsed(*term, s, {})) << term->name;
}

TEST(Terms, NamesOfModulesAreInTheRegistry) {
  EXPECT_THROW(
      registerExtension(
          {.name = "buoyancy",
           .shape = [](const ExtensionSettings&) { return std::shared_ptr<const SignedDistance>(); }}),
      std::invalid_argument);
  EXPECT_THROW(registerExtension({.name = "ours", .model = ModelPart{}}), std::invalid_argument);
}

TEST(Terms, SourcesOfASceneHaveDefaultNamesAndMaterials) {
  const Scene s = sceneOf(
      "[[heated_region]]\nbox = { size = [1, 1, 1] }\npower = 1\nmaterial = \"wax\"\n"
      "[[heated_region]]\nname = \"all\"\nbox = { size = [1, 1, 1] }\npower = 1\n"
      "[[thermostat]]\ntemperature = 300\nmaterial = \"wax\"\n");
  ASSERT_EQ(s.heatedRegions.size(), 2u);
  EXPECT_EQ(s.heatedRegions[0].name, "heated region 0");
  EXPECT_EQ(s.heatedRegions[0].material, 0);
  EXPECT_EQ(s.heatedRegions[1].material, -1);
  EXPECT_EQ(s.heatedRegions[1].where.line, 15);
  EXPECT_EQ(s.thermostats[0].material, 0);
}

}  // namespace
}  // namespace thaw
