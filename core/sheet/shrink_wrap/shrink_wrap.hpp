// SPDX-License-Identifier: Apache-2.0
// Shrink-wrap of sheets around a body (SheetBody::shrinkWrapTo): continuum, oriented particles, or another
// sheet. Forces on sheet and body are equal and opposite.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Adds the shrink-wrap forces of all sheets with a target body to sheets and bodies, and records their work.
/// Momentum is conserved.
///
/// A point for each surface cell of the grid represents the body: the centroid of its particles there. A
/// vertex of area A at pressure p gets the force
///   A p sum_c w_c (x_c - x) / |sum_c w_c (x_c - x)|,  w_c = m_c (1 - r_c^2/R^2)^2,
///   R = least r_c + two edges of a cell:
/// toward the nearest cells, in a direction that is continuous. Deep in the body, the denominator would be
/// below a fifth of sum_c w_c r_c. There, this bound replaces it, and the pressure falls to 0. Each term acts
/// on the rows of its cell in proportion to their mass. Terms are integer multiples of a small force, so sums
/// do not depend on order or ranks. Requires: the sums of addOuterForces. Collective.
void addShrinkWrap(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
