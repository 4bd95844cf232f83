// SPDX-License-Identifier: Apache-2.0
// A body force with a key of its own. A harmonic trap holds a jelly ball, which swings through it as
// cos(omega t). The sum of its kinetic and elastic energy and its energy in the trap is constant.
// trap [FOLDER]: with a folder, it writes frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace {

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
[extension.trap]
omega = "20 1/s"
[output]
every = 0.005
)";

/// Energy (J) of a particle at x: m omega^2 x^2 / 2.
double energyOf(double omega, double mass, const thaw::Vec3d& x) {
  return 0.5 * mass * omega * omega * dot(x, x);
}

thaw::Extension trap() {
  return {
      .name = "trap",
      .about = "a force towards the origin",
      .keys = {{"omega", "1/s", 10, 0, 1e6, "frequency of the trap"}},
      .load =
          [](const thaw::ExtensionSettings& settings) {
            const double stiffness = std::pow(settings.values.at("omega"), 2);
            return [stiffness](const thaw::OutsideLoad& load) {
              const thaw::Continuum& p = load.particles;
              for (std::size_t i = 0; i < p.owned; i++)
                load.force[i] -= p.position[i] * (stiffness * p.mass[i]);
            };
          },
      .stepLimit =
          [](const thaw::ExtensionSettings& settings) {
            const double omega = settings.values.at("omega");
            return omega > 0 ? 0.1 / omega : thaw::never;
          },
  };
}

struct State {
  double centre = 0, energy = 0;  // m along x; J in the trap
};

State stateOf(const thaw::Continuum& p, double omega) {
  State s;
  for (std::size_t i = 0; i < p.owned; i++) {
    s.centre += p.position[i].x / static_cast<double>(p.owned);
    s.energy += energyOf(omega, p.mass[i], p.position[i]);
  }
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::registerExtension(trap());
  const std::string out = argc > 1 ? argv[1] : "";
  thaw::Simulation sim = thaw::Simulation::fromText(scene, {.scene = "trap", .out = out}, MPI_COMM_SELF);
  const double omega = sim.scene().extensions.front().values.at("omega");
  const State start = stateOf(sim.particles(), omega);
  double worst = 0;
  sim.onStep([&] {
    const double x = stateOf(sim.particles(), omega).centre;
    worst = std::max(worst, std::abs(x - start.centre * std::cos(omega * sim.time())) / start.centre);
  });
  sim.run();
  sim.finish();
  const thaw::LedgerReport ledger = sim.ledger();
  const double given = start.energy - stateOf(sim.particles(), omega).energy,
               lost = (given - ledger.wallWork) / start.energy;
  std::printf("largest error %.2e of the amplitude; work of the trap within %.1e of its energy\n", worst,
              lost);
  return worst < 2e-3 && std::abs(lost) < 1e-3 ? 0 : 1;
}
