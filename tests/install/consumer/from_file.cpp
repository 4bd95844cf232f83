// SPDX-License-Identifier: Apache-2.0
// from_file SCENE STEPS: steps a scene at a spacing of 5 cm and prints the particles, the step and the time.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "io/scene/read_scene.hpp"
#include "io/text/version.hpp"
#include "tests/install/consumer/one_process.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::fprintf(stderr, "thaw %s\n", thaw::versionNumber());
  OneProcess run(thaw::readScene(argv[1], {"spacing=0.05"}));
  for (int step = 0; step < std::atoi(argv[2]); step++)
    if (!run.step()) return 1;
  std::printf("particles %zu\nstep %lld\ntime %.17g\n", run.world.particles.owned,
              static_cast<long long>(run.world.clock.step), run.world.clock.time);
}
