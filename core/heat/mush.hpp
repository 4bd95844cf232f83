// SPDX-License-Identifier: Apache-2.0
// Drag of a mush: between solidus and liquidus, liquid flows through growing crystals as through a porous
// solid (docs/theory/mush.md). The law is Carman-Kozeny's, as in VP87 and BVR88:
//   rho dv/dt = -C (1 - f)^2 / (f^3 + b) (v - v_s),  b = 1e-3
#pragma once
#include "core/heat/heat_view.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"

namespace thaw {

/// Returns the rate (1/s) at which the drag of a mush with this liquid fraction stops the liquid.
double mushRateOf(const Material& material, double liquidFraction);

/// Sets Continuum::mushRate and solidVelocity: the drag is relative to the mean velocity of the solid
/// neighbours. Without solid neighbours the rate is 0.
/// Requires: positions, velocities and phases of ghosts.
void findMush(const HeatView& view, const CellGrid& grid, const NeighbourLists& neighbours);

/// Applies the drag over `span` (s). It is exact for a constant rate, so it limits no step. The solid keeps
/// its motion, and Ledger::wallImpulse records the impulse. drift: time (s) for which positions have already
/// moved with the velocities before the drag; positions are corrected for it. 0: none.
void applyMush(const HeatView& view, double span, double drift);

}  // namespace thaw
