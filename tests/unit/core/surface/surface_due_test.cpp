// SPDX-License-Identifier: Apache-2.0
// Conditions for an update of the surface.
#include "core/surface/surface_due.hpp"

#include <gtest/gtest.h>

#include "core/simulation/world/world.hpp"

namespace thaw::test {

TEST(SurfaceDue, CountsStepsAndMoves) {
  World w;
  w.grid.support = 0.2;
  w.surface.lastStep = 10;
  w.scene.surface.everySteps = 0;
  w.scene.surface.everyMove = 0.5;
  w.clock.step = 1000;
  EXPECT_FALSE(surfaceDue(w.scene, w.clock, w.grid, w.surface, 0.0099));
  EXPECT_TRUE(surfaceDue(w.scene, w.clock, w.grid, w.surface, 0.0101));
  w.scene.surface.everyMove = 0;
  EXPECT_FALSE(surfaceDue(w.scene, w.clock, w.grid, w.surface, 1));
  w.scene.surface.everySteps = 5;
  w.clock.step = 14;
  EXPECT_FALSE(surfaceDue(w.scene, w.clock, w.grid, w.surface, 0));
  w.clock.step = 15;
  EXPECT_TRUE(surfaceDue(w.scene, w.clock, w.grid, w.surface, 0));
}

TEST(SurfaceDue, UsesTheNearestImageAndIgnoresNewParticles) {
  World w;
  Continuum& p = w.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.position), static_cast<AnyColumn*>(&p.surfacePosition),
                       static_cast<AnyColumn*>(&p.component)})
    p.activate(*c);
  EXPECT_EQ(largestSurfaceMove2(w.grid, w.particles, w.surface), 0);
  p.resize(3, 0);
  w.grid.periodic[0] = true;
  w.grid.period = {1, 0, 0};
  p.position[0] = {0.05, 0, 0}, p.surfacePosition[0] = {0.95, 0, 0}, p.component[0] = 1;  // across the side
  p.position[1] = {0, 0, 0.05}, p.surfacePosition[1] = {0, 0, 0}, p.component[1] = 1;
  p.position[2] = {0.5, 7, 7};  // new particle
  EXPECT_NEAR(largestSurfaceMove2(w.grid, w.particles, w.surface), 0.01, 1e-15);
}

}  // namespace thaw::test
