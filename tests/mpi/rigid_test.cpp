// SPDX-License-Identifier: Apache-2.0
// Rigid pieces that melt, fall apart, freeze and touch: the same bits on any number of ranks.
#include <gtest/gtest.h>

#include "tests/support/rebalanced_run.hpp"
#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Sum of the hashes of all particles and of all pieces, over ranks.
struct StateHash {
  std::int64_t particles = 0, pieces = 0, pieceCount = 0, melted = 0, frozen = 0;
};

StateHash hashOf(const World& w, Reducer& all) {
  StateHash sum;
  const Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    std::uint64_t h = mixBits(p.id[i] + 1) + p.piece[i];
    for (int a = 0; a < 3; a++) h = mixed(mixed(h, p.position[i][a]), p.velocity[i][a]);
    sum.particles += static_cast<std::int64_t>(h >> 24);
  }
  for (std::size_t k = 0; k < w.pieces.owned; k++) {
    if (!w.pieces.leads[k]) continue;
    std::uint64_t h = mixBits(w.pieces.id[k] + w.pieces.count[k]);
    for (int a = 0; a < 3; a++) {
      h = mixed(mixed(h, w.pieces.centre[k][a]), w.pieces.angularMomentum[k][a]);
      h = mixed(mixed(h, w.pieces.force[k][a]), w.pieces.contactImpulse[k][a]);
    }
    sum.pieces += static_cast<std::int64_t>(h >> 24);
    sum.pieceCount++;
  }
  sum.melted = w.counters.melted;
  sum.frozen = w.counters.frozen;
  all.sum({&sum.particles, sizeof sum / sizeof(std::int64_t)});
  return sum;
}

StateHash runOn(MPI_Comm group, const Scene& scene, int steps) {
  return runRebalanced(
      group, scene, steps, [](const World&) {}, hashOf);
}

TEST(Rigid, PiecesHaveTheSameBitsOnAnyNumberOfRanks) {
  const Scene scene = waxPieces();
  const StateHash alone = runOn(MPI_COMM_SELF, scene, 60), together = runOn(MPI_COMM_WORLD, scene, 60);
  EXPECT_GT(alone.melted, 0);
  EXPECT_GT(alone.frozen, 0);
  EXPECT_EQ(alone.pieceCount, together.pieceCount);
  EXPECT_EQ(alone.pieces, together.pieces);
  EXPECT_EQ(alone.particles, together.particles);
}

}  // namespace
