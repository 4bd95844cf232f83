// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/simulation/setup/rank_simulation.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw {

/// A simulation on the ranks of a communicator.
using MpiSimulation = RankSimulation<MpiReducer, MpiCellHalo, MpiBondHalo, Communicator>;

}  // namespace thaw
