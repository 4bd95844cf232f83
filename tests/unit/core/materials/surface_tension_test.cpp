// SPDX-License-Identifier: Apache-2.0
#include "core/materials/surface_tension.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(SurfaceTension, TableIsLinearAndConstantBeyondItsEnds) {
  Material m;
  m.surfaceTension = 0.07;
  EXPECT_EQ(surfaceTensionAt(m, 300), 0.07);
  m.surfaceTensionTable = {{300, 0.08}, {320, 0.04}, {330, 0.05}};
  EXPECT_DOUBLE_EQ(surfaceTensionAt(m, 290), 0.08);
  EXPECT_DOUBLE_EQ(surfaceTensionAt(m, 305), 0.07);
  EXPECT_DOUBLE_EQ(surfaceTensionAt(m, 325), 0.045);
  EXPECT_DOUBLE_EQ(surfaceTensionAt(m, 400), 0.05);
}

TEST(SurfaceTension, LargestValueOfATable) {
  EXPECT_EQ(largestTension({}), 0);
  EXPECT_EQ(largestTension({{300, 0.04}, {320, 0.08}, {330, 0.05}}), 0.08);
}

}  // namespace
}  // namespace thaw
