// SPDX-License-Identifier: Apache-2.0
// Functions after the phases of a step: they find the largest force on a particle, and count what runs.
#include <algorithm>
#include <cstdio>
#include <string>

#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

constexpr const char* scene = R"(
spacing = "5 cm"
end = 0.05
[domain]
min = [-1, -1, 0]
max = [1, 1, 1]
sides = { x = "wall", y = "wall", z = "wall" }
[material.water]
density = 1000
viscosity = "1 mPa s"
[[body]]
name = "block"
box = { size = [0.5, 0.5, 0.5] }
place = { bottom = [0, 0, 0] }
material = "water"
)";

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::Simulation sim = thaw::Simulation::fromText(scene, {.scene = "phases"}, MPI_COMM_SELF);
  std::int64_t calls[thaw::hookPhaseNames.size()]{};
  for (std::size_t k = 0; k < thaw::hookPhaseNames.size(); k++)
    sim.onPhase(static_cast<thaw::HookPhase>(k), [&calls, k] { calls[k]++; });
  double largest = 0;
  sim.onPhase(thaw::HookPhase::Forces, [&] {
    const thaw::Continuum& p = sim.particles();
    for (std::size_t i = 0; i < p.owned; i++) largest = std::max(largest, length(p.force[i]));
  });
  bool ended = false;
  sim.onEnd([&] { ended = true; });
  sim.run();
  sim.finish();
  bool same = true;
  for (std::size_t k = 0; k < thaw::hookPhaseNames.size(); k++) {
    std::printf("%s %lld\n", std::string(thaw::hookPhaseNames[k]).c_str(), static_cast<long long>(calls[k]));
    same = same && calls[k] == sim.steps();
  }
  std::printf("largest force %.3g N\n", largest);
  return same && ended && largest > 0 ? 0 : 1;
}
