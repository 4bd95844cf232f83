// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/nearest_word.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(NearestWord, FindsTypos) {
  const std::set<std::string> words{"conductivity", "heat_capacity", "young", "poisson", "x", "end"};
  EXPECT_EQ(nearestWord("conductvity", words), "conductivity");
  EXPECT_EQ(nearestWord("heatcapacity", words), "heat_capacity");
  EXPECT_EQ(nearestWord("yuong", words), "young");
  EXPECT_EQ(nearestWord("edn", words), "end");
  EXPECT_EQ(nearestWord("possion", words), "poisson");
  EXPECT_EQ(nearestWord("magnetism", words), "");
  EXPECT_EQ(nearestWord("q", words), "");
  EXPECT_EQ(nearestWord("", words), "");
  EXPECT_EQ(nearestWord(std::string(100000, 'a'), words), "");
  EXPECT_EQ(suggestion("yung", words), "; did you mean 'young'?");
  EXPECT_EQ(suggestion("magnetism", words), "");
}

}  // namespace
}  // namespace thaw
