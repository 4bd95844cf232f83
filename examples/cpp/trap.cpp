// SPDX-License-Identifier: Apache-2.0
// A force of the program's own: a harmonic trap holds a drop, which swings through it as cos(omega t). The
// force is in the ledger as work from outside.
#include <cmath>
#include <cstdio>

#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

constexpr const char* scene = R"(
spacing = "5 cm"
end = 0.3
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
gravity = [0, 0, 0]
[material.jelly]
density = 1000
young = "1 MPa"
[[body]]
name = "ball"
sphere = { radius = 0.2 }
place = { move = [0.05, 0, 0] }
material = "jelly"
)";

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  constexpr double omega = 20;  // 1/s
  thaw::Simulation sim = thaw::Simulation::fromText(scene, {.scene = "trap"}, MPI_COMM_SELF);
  sim.addForce([](const thaw::OutsideLoad& load) {
    const thaw::Continuum& p = load.particles;
    for (std::size_t i = 0; i < p.owned; i++) load.force[i] -= p.position[i] * (omega * omega * p.mass[i]);
  });
  const auto centre = [&sim] {
    const thaw::Continuum& p = sim.world().particles;
    double sum = 0;
    for (std::size_t i = 0; i < p.owned; i++) sum += p.position[i].x;
    return sum / static_cast<double>(p.owned);
  };
  const double start = centre();
  double worst = 0;
  sim.onStep([&] { worst = std::max(worst, std::abs(centre() - start * std::cos(omega * sim.time()))); });
  sim.run();
  const thaw::LedgerReport ledger = sim.ledger();
  std::printf("largest error %.2e of the amplitude, energy residual %.1e of the scale\n", worst / start,
              ledger.energyResidual / ledger.energyScale);
  return worst < 2e-3 * start ? 0 : 1;
}
