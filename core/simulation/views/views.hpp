// SPDX-License-Identifier: Apache-2.0
// Views for modules. A view refers to the data of a run that a module reads and changes.
#pragma once
#include "core/flow/density/carried_density.hpp"
#include "core/heat/evaporation.hpp"
#include "core/heat/heat_view.hpp"
#include "core/oriented/data/oriented_view.hpp"
#include "core/rigid/rigid_view.hpp"
#include "core/sheet/data/sheet_view.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/sleep/sleep_view.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/walls/wall_view.hpp"

namespace thaw {

/// dt (s): last step, 0 at the start.
inline CarryContext carryContext(World& w, StepTools& t, double dt) {
  return {w.scene,
          w.modules,
          w.grid,
          w.particles,
          w.neighbours,
          w.walls,
          w.initialSummedDensity,
          w.clock,
          w.counters,
          t.liquids,
          t.walls.tables,
          t.sums.scales.inverseLatticeSum,
          t.carry,
          t.walls.contacts,
          t.sleep.steady,
          dt};
}

inline HeatView heatView(World& w) { return {w.scene, w.modules, w.particles, w.solids, w.clock, w.ledger}; }

inline RecordContext recordContext(const World& w, const std::vector<LiquidMaterial>& liquids) {
  return {w.scene, w.modules, w.grid, liquids, w.clock.substeps};
}

inline EvaporationView evaporationView(World& w, StepTools& t) {
  return {heatView(w),
          recordContext(w, t.liquids),
          w.neighbours,
          t.walls.contacts,
          t.walls.tables,
          t.sums.scales.inverseLatticeSum,
          t.sums.scales.selfExcess};
}

inline OrientedView orientedView(World& w, StepTools& t) {
  return {w.oriented, t.oriented, w.particles, w.ledger, w.counters, t.redistribution.sort, t.times, w.scene,
          w.modules,  w.grid,     w.cells,     w.walls,  w.clock};
}

inline RigidView rigidView(World& w, RigidWork& rigid) {
  return {w.scene,  w.grid, w.particles, w.cells, w.pieces,  w.walls,
          w.ledger, rigid,  w.modules,   w.clock, w.counters};
}

inline SheetView sheetView(World& w) {
  return {w.sheets, w.particles, w.oriented, w.ledger, w.scene, w.modules, w.grid, w.cells, w.walls, w.clock};
}

inline SleepView sleepView(World& w, StepTools& t) {
  return {w.scene, w.grid,  w.particles, w.cells,    w.neighbours, w.solids,     w.bonds,
          w.walls, w.clock, w.ledger,    w.counters, t.sleep,      t.sums.inner, t.walls.contacts};
}

inline SurfaceView surfaceView(World& w) {
  return {w.scene, w.modules, w.grid, w.walls, w.clock, w.particles, w.solids, w.surface};
}

inline WallView wallView(World& w) {
  return {w.scene, w.modules, w.grid, w.particles, w.cells, w.solids, w.walls, w.ledger, w.counters};
}

}  // namespace thaw
