// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/sampling/thin_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thaw {
namespace {

// On a lattice any distance keeps either few points or all. The search for the wanted share must not end with
// all.
TEST(ThinPoints, KeepsTheWantedShareOfALattice) {
  SampledPoints m;
  for (int j = 0; j < 18; j++)
    for (int i = 0; i < 20; i++)
      addPoint(m, {0.05 * (i + 0.5 * (j & 1)), 0.05 * 0.8660254 * j, 0.01 * std::sin(0.5 * i)}, {0, 0, 1});
  for (const double share : {0.05, 0.25, 0.37, 0.38, 0.5, 0.8, 0.99}) {
    const SampledPoints thin = thinPoints(m, share, 1);
    EXPECT_EQ(thin.places.size(), static_cast<std::size_t>(std::ceil(share * 360 - 1e-9))) << share;
    for (std::size_t i = 0; i < thin.places.size(); i++)
      for (std::size_t k = 0; k < i; k++) ASSERT_GT(length(thin.places[i] - thin.places[k]), 0.01);
  }
}

}  // namespace
}  // namespace thaw
