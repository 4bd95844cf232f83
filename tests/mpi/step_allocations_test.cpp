// SPDX-License-Identifier: Apache-2.0
// A steady step allocates nothing: solid, liquid, heat, walls, contacts, surface tension.
#include <gtest/gtest.h>

#include "parallel/mpi_simulation.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/simulation.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

Scene blockInAPool() {
  Scene s;
  s.spacing = 0.01;
  s.domain.min = {0, 0, 0};
  s.domain.max = {0.2, 0.12, 0.3};
  s.domain.side[0] = s.domain.side[1] = {Side::Wall, Side::Wall};
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.output.every = 0;
  s.materials.emplace_back();
  Material& water = s.materials[0];
  water.viscosity = {5, 5};
  water.soundSpeed = 15;
  water.surfaceTension = 0.05;
  water.conductivity = {1, 1};
  s.materials.emplace_back();
  Material& wax = s.materials[1];
  wax.name = "wax";
  wax.density = 900;
  wax.young = {1e5, 0};
  wax.damping = 20;
  wax.viscosity = {1, 1};
  wax.soundSpeed = 15;
  wax.conductivity = {1, 1};
  wax.solidus = 330;
  wax.liquidus = 340;
  addBox(s, {0, 0, 0}, {0.2, 0.12, 0.05});
  Body& block = addBox(s, {0.05, 0.03, 0.06}, {0.15, 0.09, 0.1});
  block.material = 1;
  block.temperature = 300;
  return s;
}

void runSteady(const Scene& scene, int mostBusy = 10) {
  const Communicator comm;
  MpiSimulation simulation(comm);
  simulation.world.scene = scene;
  simulation.prepare({});
  simulation.start({});
  for (int k = 0; k < 150; k++) ASSERT_TRUE(simulation.step().finite);
  int busy = 0;  // steps with growth: a particle arrives at this rank, or a list exceeds its largest length
  long most = 0;
  for (int k = 0; k < 50; k++) {
    const long before = allocations;
    ASSERT_TRUE(simulation.step().finite);
    const long made = allocations - before;
    busy += made > 0;
    most = std::max(most, made);
  }
  EXPECT_LE(busy, mostBusy) << "up to " << most << " allocations in a step";
}

}  // namespace

// With motion, lists exceed their largest length now and then.
TEST(Step, FewStepsAllocateInMotion) { runSteady(blockInAPool()); }

// Without falling bodies no step allocates: liquid, solid, heat, contacts and walls.
TEST(Step, SteadyStepAllocatesNothing) {
  Scene s = blockInAPool();
  s.domain.gravity = {};
  s.numerics.fixedStep = 1e-5;
  runSteady(s, 0);
}

TEST(Step, SteadyImplicitViscosityAllocatesNothing) {
  Scene s = blockInAPool();
  s.numerics.viscositySolver = ViscositySolver::Implicit;
  runSteady(s);
}
