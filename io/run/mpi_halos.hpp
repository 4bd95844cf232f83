// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/simulation/world/world_halos.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw {

/// Halos of a world over the ranks of a communicator.
using MpiHalos = WorldHalos<MpiCellHalo, MpiBondHalo>;

}  // namespace thaw
