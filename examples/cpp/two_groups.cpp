// SPDX-License-Identifier: Apache-2.0
// Two groups of ranks run two simulations at the same time: mpirun -n 4 two_groups SCENE [FOLDER]
#include <cstdio>
#include <string>

#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  if (argc < 2) return 2;
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int group = 2 * rank / ranks;  // the first half of the ranks, and the second
  MPI_Comm mine;
  MPI_Comm_split(MPI_COMM_WORLD, group, rank, &mine);
  {
    const std::string spacing = group == 0 ? "spacing=0.06" : "spacing=0.05";
    const std::string out = argc > 2 ? argv[2] + ("/" + std::to_string(group)) : "";
    thaw::Simulation sim({.scene = argv[1], .out = out, .overrides = {spacing}}, mine);
    sim.runSteps(20);
    sim.finish();
    const thaw::LedgerReport ledger = sim.ledger();
    if (sim.rank() == 0)
      std::printf("group %d: %lld particles, t %.6g s\n", group, static_cast<long long>(ledger.particles),
                  sim.time());
  }
  MPI_Comm_free(&mine);
  return 0;
}
