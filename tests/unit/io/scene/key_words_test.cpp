// SPDX-License-Identifier: Apache-2.0
// Descriptions in the table of keys.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

KeyDescription keyOf(const std::string& table, const std::string& key) {
  const std::vector<KeyDescription> keys = sceneKeys();
  const auto at = std::ranges::find_if(
      keys, [&](const KeyDescription& k) { return k.table == table && k.key == key; });
  return at == keys.end() ? KeyDescription{} : *at;
}

bool says(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

TEST(KeyWords, NameTheKeysWithTwoValues) {
  for (const char* key : {"viscosity", "young", "poisson", "yield_strain", "creep_rate", "conductivity",
                          "heat_capacity", "density"})
    EXPECT_TRUE(says(keyOf("material.NAME", key).range, "{ solid = ..., liquid = ... }")) << key;
  for (const char* key : {"damping", "friction"})
    EXPECT_FALSE(says(keyOf("material.NAME", key).range, "solid =")) << key;
}

TEST(KeyWords, ExplainHowRestitutionsCombine) {
  EXPECT_TRUE(says(keyOf("obstacle", "restitution").about, "the smaller of this and the material's"));
  EXPECT_TRUE(says(keyOf("material.NAME", "restitution").about, "the smaller of the two"));
}

TEST(KeyWords, GiveTheOrderOfTensors) {
  EXPECT_TRUE(says(keyOf("output", "fields").about, "xx, yy, zz, xy, yz, xz"));
}

TEST(KeyWords, GiveTheSmallestPeriodicThickness) {
  EXPECT_TRUE(says(keyOf("domain.sides", "z").about, "6 spacings if `numerics.support` is 2"));
}

TEST(KeyWords, ManualHasLimitsAndAnExample) {
  const std::string text = sceneDocumentation();
  EXPECT_TRUE(says(text, "at most 16384 characters"));
  EXPECT_TRUE(says(text, "Bingham"));
}

}  // namespace
}  // namespace thaw
