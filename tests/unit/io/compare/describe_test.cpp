// SPDX-License-Identifier: Apache-2.0
// Output of thaw compare for files with little in common.
#include <gtest/gtest.h>

#include "io/compare/compare.hpp"

namespace thaw {
namespace {

TEST(Describe, ListsAFewOfEachTypeAndCountsTheRest) {
  Comparison c;
  c.general.push_back("step: A 3, B 4");
  for (int k = 0; k < 60; k++)
    c.general.push_back("coefficient.oriented.film.k" + std::to_string(k) + " is in A only");
  for (int k = 0; k < 4; k++) c.general.push_back("ledger k" + std::to_string(k) + ": A 0, B 1");
  const std::vector<std::string> lines = describe(c);
  ASSERT_EQ(lines.size(), 11u);
  EXPECT_EQ(lines[1], c.general[0]);
  EXPECT_EQ(lines[2], c.general[1]);
  EXPECT_EQ(lines[5], c.general[4]);
  EXPECT_EQ(lines[9], "ledger k3: A 0, B 1");
  EXPECT_EQ(lines[10], "... and 56 more of coefficient (--all lists them)");
  EXPECT_EQ(describe(c, true).size(), 1 + c.general.size());
}

}  // namespace
}  // namespace thaw
