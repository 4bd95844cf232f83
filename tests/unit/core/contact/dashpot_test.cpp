// SPDX-License-Identifier: Apache-2.0
#include "core/contact/dashpot.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace thaw;

// A mass that hits a spring and a dashpot, which never pull, in small steps.
TEST(Dashpot, GivesTheRequestedRestitution) {
  for (const double e : {1.0, 0.9, 0.6, 0.3, 0.1, 0.03}) {
    const double z = dashpotRatio(e), dt = 2e-5;
    double x = 0, v = 1;  // toward the spring; mass and stiffness are 1
    for (int n = 0; n < 1000000; n++) {
      const double force = std::max(0.0, x + 2 * z * v);
      if (force == 0 && v < 0) break;
      v -= force * dt;
      x += v * dt;
    }
    EXPECT_NEAR(-v, e, 2e-3) << e;
  }
  EXPECT_EQ(dashpotRatio(1), 0);
  EXPECT_EQ(dashpotRatio(0), dashpotRatio(0.02));
}
