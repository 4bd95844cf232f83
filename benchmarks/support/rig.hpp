// A scene on the ranks of a communicator, as a run has it but without files.
#pragma once
#include <memory>

#include "core/setup/setup.hpp"
#include "parallel/balance.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw::bench {

struct Rig {
  World w;
  StepTools tools;
  MpiReducer all;
  std::unique_ptr<MpiCellHalo> cells;
  MpiBondHalo bonds;
  WorkMeter meter;

  /// change: what is done to the particles before forces are found for the first time; bonds form there.
  /// load: for scenes with meshes.
  template<class Change>
  Rig(const Communicator& comm, const Scene& scene, Change change, const MeshLoader& load = {})
      : all(comm), bonds(comm) {
    w.scene = scene;
    prepareWorld(w, tools, load);
    cells = std::make_unique<MpiCellHalo>(comm, w.grid);
    sampleWorld(w, halos(), tools, load);
    change(w.particles);
    tools.bondsAtStart = w.modules.solid;
    takeStock(w, halos(), tools);
  }
  Halos halos() { return {all, *cells, bonds}; }

  /// Some steps and looks at the balance, so that what is timed then has its cells where a run of some length
  /// has them.
  void settle() {
    if (all.size() == 1) return;
    meter.seconds = tools.times.seconds;
    for (int look = 0; look < 8; look++) {  // twice: after a new partition three looks are let go by
      for (int k = 0; k < 3; k++) thaw::step(w, halos(), tools, {});
      balance(w, *cells, tools, meter);
    }
    thaw::step(w, halos(), tools, {});  // particles go to their ranks
  }

  /// One step, with a look at the balance as often as a run has it.
  StepOutcome step() {
    const StepOutcome o = thaw::step(w, halos(), tools, {});
    if (w.clock.step % 25 == 0) balance(w, *cells, tools, meter);
    return o;
  }
};

}  // namespace thaw::bench
