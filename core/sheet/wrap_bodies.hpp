// Sheets that are drawn toward a body (SheetBody::wrapTo): continuum, oriented particles, another sheet. The
// body is drawn toward the sheet as strongly.
#pragma once
#include "core/sheet/outer_forces.hpp"

namespace thaw {

/// Adds the wrap of all sheets that are wrapped round a body, and what the body feels of it, to the forces of
/// both, and its work on both to the books; momentum is kept.
///
/// The body is, for this, a point for each cell of the grid on its surface, in the middle of what it has
/// there. A vertex of area A is drawn with the pressure p by
///   A p sum_c w_c (x_c - x) / |sum_c w_c (x_c - x)|,  w_c = m_c (1 - r_c^2/R^2)^2,
///   R = least r_c + two edges of a cell:
/// toward what is nearest, along a direction that does not jump; where the sum is below a fifth of sum_c w_c
/// r_c, in the midst of the body, this stands below the line and the pressure falls to 0. Each term is felt
/// by the rows of its cell, by their mass. Terms are whole multiples of one small force: their sums over
/// vertices are the same in any order, on any number of ranks. Needs the sums of addOuterForces. Collective.
void addBodyWrap(World& world, Halos halos, const SheetVelocities& now);

}  // namespace thaw
