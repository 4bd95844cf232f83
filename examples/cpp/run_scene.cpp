// SPDX-License-Identifier: Apache-2.0
// run_scene SCENE STEPS: steps a scene at a spacing of 5 cm and prints the particles, the step and the time.
#include <cstdio>
#include <cstdlib>

#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

int main(int argc, char** argv) try {
  thaw::MpiSession mpi(&argc, &argv);
  if (argc != 3) return 2;
  thaw::Simulation sim({.scene = argv[1], .overrides = {"spacing=0.05"}});
  sim.runSteps(std::atoi(argv[2]));
  const long long particles = sim.ledger().particles, steps = sim.steps();
  if (sim.rank() == 0) std::printf("particles %lld\nstep %lld\ntime %.17g\n", particles, steps, sim.time());
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
