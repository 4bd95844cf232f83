// SPDX-License-Identifier: Apache-2.0
// Properties of all terms of the registry (core/terms/terms.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
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
    const char* limit = term->model->limit;
    EXPECT_TRUE(limit || !term->model->stepLimit) << term->name;
    const auto isLimit = [&](std::string_view name) { return limit && name == limit; };
    EXPECT_TRUE(!limit || std::any_of(limitNames.begin(), limitNames.end(), isLimit)) << term->name;
  }
}

TEST(Terms, KeysBelongToOneTerm) {
  std::set<std::string> keys;
  for (const Extension* term : modelTerms()) {
    EXPECT_FALSE(keysOf(*term->model).empty()) << term->name;
    for (const std::string& key : keysOf(*term->model)) EXPECT_TRUE(keys.insert(key).second) << key;
  }
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
