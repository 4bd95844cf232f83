// SPDX-License-Identifier: Apache-2.0
// Nearest neighbours of scattered points.
#include "core/geometry/trees/point_tree.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(PointTree, APointIsNearestToItself) {
  const PointTree tree({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 2, 0}});
  EXPECT_EQ(tree.nearest({0, 2, 0}, 1), std::vector<std::uint32_t>{3});
  EXPECT_EQ(tree.nearest({1, 0, 0}, 2), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(tree.nearest({0, 0, 0}, 9).size(), 4u);
}

}  // namespace
}  // namespace thaw
