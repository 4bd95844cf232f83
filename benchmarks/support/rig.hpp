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
  template<class Change> Rig(const Communicator& comm, const Scene& scene, Change change) : all(comm), bonds(comm) {
    w.scene = scene;
    prepareWorld(w, tools, {});
    cells = std::make_unique<MpiCellHalo>(comm, w.grid);
    sampleWorld(w, halos(), tools, {});
    change(w.particles);
    tools.bondsAtStart = w.modules.solid;
    takeStock(w, halos(), tools);
  }
  Halos halos() { return {all, *cells, bonds}; }

  /// One step, with a look at the balance as often as a run has it.
  StepOutcome step() {
    const StepOutcome o = thaw::step(w, halos(), tools, {});
    if (w.clock.step % 25 == 0) balance(w, *cells, tools, meter);
    return o;
  }
};

}  // namespace thaw::bench
