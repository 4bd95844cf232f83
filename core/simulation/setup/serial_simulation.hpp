// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/halo/serial.hpp"
#include "core/simulation/setup/rank_simulation.hpp"
#include "core/solid/bonds/serial_bond_halo.hpp"

namespace thaw {

/// A simulation of one process without MPI.
using SerialSimulation = RankSimulation<SerialReducer, SerialCellHalo, SerialBondHalo>;

}  // namespace thaw
