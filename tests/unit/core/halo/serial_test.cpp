// SPDX-License-Identifier: Apache-2.0
#include "core/halo/serial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/halo_check.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(SerialCellHalo, ImagesAgreeWithBruteForceForEveryChoiceOfPeriodicAxes) {
  for (int periodic = 0; periodic < 8; periodic++)
    for (const Vec3i& cells : {Vec3i{3, 3, 3}, Vec3i{6, 4, 5}})
      for (const std::uint64_t number : {0, 1, 900}) {
        SCOPED_TRACE(testing::Message()
                     << "periodic " << periodic << ", cells " << cells.x << ", particles " << number);
        SerialReducer all;
        const Cloud cloud{plainGrid(cells, periodic), number};
        SerialCellHalo halo(cloud.grid);
        HaloRig rig(cloud, halo, all);
        rig.start(true);
        rig.checkAll();
        for (rig.cloud.time = 1; rig.cloud.time < 3; rig.cloud.time++) {
          rig.place();
          rig.checkAll();
        }
      }
}

TEST(SerialCellHalo, RefusesAnAxisWhereACellWouldMeetItsOwnImage) {
  EXPECT_THROW(SerialCellHalo(plainGrid({8, 2, 8}, 2)), std::invalid_argument);
  EXPECT_NO_THROW(SerialCellHalo(plainGrid({8, 2, 1}, 1)));
}

TEST(SerialReducer, ReducesNaNToInfinity) {
  SerialReducer all;
  double values[3] = {-1, std::numeric_limits<double>::quiet_NaN(), 5};
  all.maximum(values);
  EXPECT_EQ(values[0], -1);
  EXPECT_EQ(values[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(values[2], 5);
}
