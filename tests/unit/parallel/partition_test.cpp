// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "parallel/decomposition.hpp"

using namespace thaw;

// Five ranks are bisected as 2 (1, 1) and 3 (1, 2 (1, 1)).
TEST(Partition, FindsOwnersAmongFullAndEmptyBoxes) {
  const Partition p({{{0, 0, 0}, {4, 6, 5}},  // below x = 4
                     {{4, 0, 0}, {4, 6, 5}},  // empty
                     {{4, 0, 0}, {9, 2, 5}},  // y < 2
                     {{4, 2, 0}, {9, 6, 0}},  // empty
                     {{4, 2, 0}, {9, 6, 5}}});
  for (int guess = 0; guess < 5; guess++) {
    Vec3i c;
    for (c.z = 0; c.z < 5; c.z++)
      for (c.y = 0; c.y < 6; c.y++)
        for (c.x = 0; c.x < 9; c.x++) EXPECT_EQ(p.owner(c, guess), c.x < 4 ? 0 : c.y < 2 ? 2 : 4);
    EXPECT_EQ(p.owner({9, 0, 0}, guess), -1);
    EXPECT_EQ(p.owner({0, 0, -1}, guess), -1);
  }
}

TEST(Partition, OneRankOwnsAll) {
  const Partition p(std::vector<CellBox>{{{0, 0, 0}, {3, 3, 3}}});
  EXPECT_EQ(p.owner({2, 2, 2}, 0), 0);
  EXPECT_EQ(p.owner({3, 2, 2}, 0), -1);
}

TEST(Partition, OnlyOneOfManyRanksHasCells) {
  std::vector<CellBox> boxes(6);
  boxes[3] = {{0, 0, 0}, {1, 1, 1}};
  const Partition p(boxes);
  EXPECT_EQ(p.owner({0, 0, 0}, 5), 3);
}
