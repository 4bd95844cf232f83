// SPDX-License-Identifier: Apache-2.0
// A scene on the ranks of a communicator, set up as in a run but without files.
#pragma once
#include "core/simulation/setup/setup.hpp"
#include "io/run/mpi_halos.hpp"
#include "parallel/balance.hpp"

namespace thaw::bench {

struct Rig {
  World w;
  StepTools tools;
  MpiReducer all;
  MpiHalos tables;
  WorkMeter meter;

  /// `change` acts on the particles before bonds form and the first forces are computed. `load` reads the
  /// meshes of scenes.
  template<class Change>
  Rig(const Communicator& comm, const Scene& scene, Change change, const MeshLoader& load = {}) : all(comm) {
    w.scene = scene;
    prepareWorld(w, tools, load);
    tables.make(w, comm);
    sampleWorld(w, halos(), tools, load);
    change(w.particles);
    tools.bondsAtStart = w.modules.solid;
    initializeForces(w, halos(), tools);
  }
  Halos halos() { return tables.with(all); }

  /// Takes some steps with balance checks, so that cells are distributed as in a longer run.
  void settle() {
    if (all.size() == 1) return;
    meter.seconds = tools.times.seconds;
    for (int look = 0; look < 8; look++) {  // twice, since three checks after a new partition are skipped
      for (int k = 0; k < 3; k++) thaw::step(w, halos(), tools, {});
      balance(w, *tables.cells, tools, meter);
    }
    thaw::step(w, halos(), tools, {});  // particles migrate to their ranks
  }

  /// Takes one step, with balance checks as often as a run has them.
  StepOutcome step() {
    const StepOutcome o = thaw::step(w, halos(), tools, {});
    if (w.clock.step % 25 == 0) balance(w, *tables.cells, tools, meter);
    return o;
  }
};

}  // namespace thaw::bench
