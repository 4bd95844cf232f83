// SPDX-License-Identifier: Apache-2.0
// A scene in one process, with the installed headers.
#pragma once
#include <memory>

#include "core/halo/serial.hpp"
#include "core/simulation/setup/setup.hpp"
#include "core/solid/bonds/serial_bond_halo.hpp"

struct OneProcess {
  thaw::World world;
  thaw::StepTools tools;
  thaw::SerialReducer all;
  std::unique_ptr<thaw::SerialCellHalo> cells;
  thaw::SerialBondHalo bonds;

  explicit OneProcess(const thaw::Scene& scene) {
    world.scene = scene;
    thaw::prepareWorld(world, tools, {});
    cells = std::make_unique<thaw::SerialCellHalo>(world.grid);
    thaw::startWorld(world, halos(), tools, {});
  }
  thaw::Halos halos() { return {all, *cells, bonds}; }
  bool step() { return thaw::step(world, halos(), tools, {}).finite; }
};
