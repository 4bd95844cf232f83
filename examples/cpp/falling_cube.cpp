// SPDX-License-Identifier: Apache-2.0
// A scene made in code. A jelly cube falls for 0.1 s in free space, exactly g t^2 / 2, and its energy is
// conserved.
#include <cmath>
#include <cstdio>

#include "core/math/exact_sum.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace {

thaw::Scene fallingCube() {
  thaw::Scene scene;
  scene.spacing = 0.02;
  scene.end = 0.1;
  scene.domain.min = {-1, -1, -1};
  scene.domain.max = {1, 1, 1};
  scene.domain.gravity = {0, 0, -10};
  thaw::Material jelly;
  jelly.name = "jelly";
  jelly.young = {1e5, 0};
  scene.materials = {jelly};
  thaw::Body cube;
  cube.name = "cube";
  cube.shape.size = {0.1, 0.1, 0.1};
  scene.bodies = {cube};
  return scene;
}

double meanHeight(const thaw::Continuum& particles) {
  thaw::ExactSum sum;
  for (std::size_t i = 0; i < particles.owned; i++) sum.add(particles.position[i].z);
  return sum.value() / static_cast<double>(particles.owned);
}

}  // namespace

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::Simulation sim(fallingCube(), {.scene = "falling cube"}, MPI_COMM_SELF);
  const thaw::Continuum& particles = sim.world().particles;
  const double start = meanHeight(particles);
  sim.run();
  const double fallen = start - meanHeight(particles), t = sim.time();
  const thaw::LedgerReport ledger = sim.ledger();
  const double residual = ledger.energyResidual / ledger.energyScale;
  std::printf("%zu particles fell %.9g m in %.3g s; exact: %.9g m; energy residual %.1e of the scale\n",
              particles.owned, fallen, t, 5 * t * t, residual);
  const bool exact = std::abs(fallen - 5 * t * t) < 1e-9 && std::abs(residual) < 1e-6;
  return particles.owned == 125 && exact ? 0 : 1;
}
