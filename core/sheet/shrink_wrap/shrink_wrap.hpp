// SPDX-License-Identifier: Apache-2.0
// Shrink-wrap of sheets around a body (SheetBody::shrinkWrapTo): continuum, oriented particles, another
// sheet. Forces on both are equal and opposite.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Adds the shrink-wrap forces of all sheets with a target body to both sides, and records their work;
/// momentum is conserved.
///
/// The body is represented by a point for each surface cell of the grid, the centroid of its particles there.
/// A vertex of area A at pressure p gets the force
///   A p sum_c w_c (x_c - x) / |sum_c w_c (x_c - x)|,  w_c = m_c (1 - r_c^2/R^2)^2,
///   R = least r_c + two edges of a cell:
/// toward the nearest cells, in a direction that is continuous. Deep in the body, the sum is below a fifth of
/// sum_c w_c r_c. There this bound replaces the denominator, and the pressure falls to 0. Each term acts on
/// the rows of its cell by their mass. Terms are integer multiples of a small force, so sums do not depend on
/// order or ranks. Requires: the sums of addOuterForces. Collective.
void addShrinkWrap(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
