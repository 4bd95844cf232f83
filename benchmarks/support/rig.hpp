// SPDX-License-Identifier: Apache-2.0
// A scene on the ranks of a communicator, set up as in a run but without files.
#pragma once
#include "parallel/balance.hpp"
#include "parallel/mpi_simulation.hpp"

namespace thaw::bench {

struct Rig : MpiSimulation {
  World& w = world;
  WorkMeter meter;

  /// `change` acts on the particles before bonds form and the first forces are computed. `load` reads the
  /// meshes of scenes.
  Rig(const Communicator& comm, const Scene& scene, const ParticleChange& change, const MeshLoader& load = {})
      : MpiSimulation(comm) {
    world.scene = scene;
    prepare(load);
    start(load, change);
  }
  Rig(const Rig&) = delete;

  /// Takes some steps with balance checks, so that cells are distributed as in a longer run.
  void settle() {
    if (all.size() == 1) return;
    meter.seconds = tools.times.seconds;
    for (int look = 0; look < 8; look++) {  // twice, since three checks after a new partition are skipped
      for (int k = 0; k < 3; k++) MpiSimulation::step();
      balance(w, *tables.cells, tools, meter);
    }
    MpiSimulation::step();  // particles migrate to their ranks
  }

  /// Takes one step, with balance checks as often as a run has them.
  StepOutcome step() {
    const StepOutcome o = MpiSimulation::step();
    if (w.clock.step % 25 == 0) balance(w, *tables.cells, tools, meter);
    return o;
  }
};

}  // namespace thaw::bench
