// SPDX-License-Identifier: Apache-2.0
// Memory requested at the start. New memory takes a third of the start's time, so it is requested once.
#include <gtest/gtest.h>

#include "core/math/hash_random.hpp"
#include "parallel/mpi_simulation.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/measured.hpp"
#include "tests/support/simulation.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

Scene block(bool solid) {
  Scene s;
  s.spacing = 0.01;
  s.numerics.support = s.numerics.bondSupport = 2.13;
  s.numerics.precision = s.numerics.elasticPrecision = Precision::Single;
  s.numerics.selfContact = false;
  s.domain.min = {-0.5, -0.5, -0.5};
  s.domain.max = {0.5, 0.5, 0.5};
  s.domain.gravity = {};
  s.output.every = 0;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 10;
  if (solid) s.materials[0].young = {1e5, 0};
  addBox(s, {-0.15, -0.15, -0.15}, {0.15, 0.15, 0.15});
  return s;
}

/// Bytes per particle that a start allocates on one rank, kept or not. Particles are off their lattice, so
/// that numbers of bonds differ.
double askedFor(bool solid) {
  const Communicator comm;
  const long before = allocatedBytes;
  MpiSimulation simulation(comm);
  simulation.world.scene = block(solid);
  simulation.prepare({});
  const double most = 0.1 * simulation.world.scene.spacing;
  simulation.start({}, [most](Continuum& p) {
    for (std::size_t i = 0; i < p.owned; i++)
      for (int a = 0; a < 3; a++)
        p.position[i][a] += most *
                            (2 * randomUniform(1, Purpose::Separate, p.id[i], static_cast<std::uint64_t>(a)) -
                             1);
  });
  return static_cast<double>(allocatedBytes - before) / static_cast<double>(simulation.world.particles.owned);
}

}  // namespace

// The limit leaves no room for temporary copies: bonds made twice, columns, ids and lists that double, or
// stored positions that follow from their numbers.
TEST(Start, RequestsMemoryOnce) {
  if (Communicator().size() > 1) GTEST_SKIP() << "messages of the first partition add to it";
  const double solid = askedFor(true), fluid = askedFor(false);
  measured("bytes per particle requested at the start: solid %.0f, fluid %.0f", solid, fluid);
  EXPECT_LT(solid, 1300);
  EXPECT_LT(fluid, 630);
}
