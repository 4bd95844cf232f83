// SPDX-License-Identifier: Apache-2.0
// Pressure sums for the packing of bodies.
#pragma once
#include <vector>

#include "core/fluid/pair_sums/pair_sum_work.hpp"
#include "core/halo/halos.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Searches neighbours, and adds the force of a uniform pressure of 1 Pa, -2 V_i sum V_j grad W (N), to
/// Continuum::force. Requires: ghosts.
void sumUnitPressure(World& world, const std::vector<LiquidMaterial>& liquids, PairSumWork& work);

/// Computes the relative density (without walls), and a force (N) in Continuum::force. The pressure is 1 Pa
/// times the excess of the liquids' relative density above 1. The force is -V_i times the gradient (1/m),
/// with respect to the position of i, of half the sum of squared excesses. Call it after sumUnitPressure, at
/// the same positions. Collective.
void sumExcessPressure(World& world, CellHalo& halo, const std::vector<LiquidMaterial>& liquids,
                       PairSumWork& work);

}  // namespace thaw
