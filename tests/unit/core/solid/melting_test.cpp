// SPDX-License-Identifier: Apache-2.0
#include "core/solid/melting.hpp"

#include <gtest/gtest.h>

#include "core/solid/elasticity/solid_state.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(Melting, RemovesBondsAtBothEndsAndRecordsTheirEnergy) {
  const auto points = lattice({6, 5, 5}, 0.1, 0.2);
  const auto b = makeBody(points, {elasticMaterial()});
  Continuum& p = b->particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.phase), static_cast<AnyColumn*>(&p.solidIndex)})
    p.activate(*c);
  p.resize(points.size(), 0);
  b->solids.activate(b->solids.melted);
  const Mat3d f{{{1.1, 0.1, 0}, {0, 0.9, 0}, {0.05, 0, 1}}};
  for (std::size_t s = 0; s < points.size(); s++) {
    b->solids.position[s] = f * points[s] + 0.005 * noise3(s, 1);
    b->solids.particle[s] = p.solidIndex[s] = static_cast<std::uint32_t>(s);
    p.phase[s] = s % 7 == 3 ? Liquid : Solid;
  }
  computeForces(*b);
  const double before = totalEnergy(*b);
  markMelted(p, b->solids);
  ExactSum jump;
  EXPECT_GT(dropMeltedBonds(b->work, p, b->solids, b->bonds, jump),
            static_cast<std::int64_t>(points.size()) / 2);
  EXPECT_TRUE(b->bonds.broken);
  const double after = totalEnergy(*b);
  EXPECT_NEAR(jump.value(), before - after, 1e-12 * before);
  EXPECT_GT(std::abs(jump.value()), 0.05 * before);
  for (std::size_t s = 0; s < points.size(); s++)
    for (int k = 0; k < b->bonds.capacity; k++) {
      const std::size_t at = b->bonds.at(s, k);
      const bool liquidEnd = p.phase[s] == Liquid || p.phase[b->bonds.neighbour[at]] == Liquid;
      EXPECT_FALSE(b->bonds.hasBond(s, k) && liquidEnd);
    }
  // the recorded energy is that of the next force evaluation
  computeForces(*b);
  EXPECT_NEAR(totalEnergy(*b), after, 1e-10 * before);
  // once more: no bond is left to remove
  EXPECT_EQ(dropMeltedBonds(b->work, p, b->solids, b->bonds, jump), 0);
}
