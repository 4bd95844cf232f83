// SPDX-License-Identifier: Apache-2.0
// Adapts the spacing of surfels to the curvature of the surface, which keeps small drops and edges (K05,
// future work).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/row_lists.hpp"

namespace thaw {

/// Target angle (rad) between the normals of neighbouring surfels on a curved surface.
inline constexpr double angleBetween = 0.5;
/// Largest growth of the target spacing per distance. Neighbours differ by a factor of at most 1.3.
inline constexpr double grading = 0.25;

/// Adapts Surfels::radius of owned surfels and ghosts to the curvature. The target is angleBetween over the
/// largest curvature, averaged over neighbours, clamped to [finest, spacing] (m) and graded. Deviations below
/// a tenth remain, and larger ones are halved, so the density does not oscillate. With finest = spacing,
/// radii return to the spacing everywhere. Requires: ghosts with position, normal, component and radius;
/// lists within `reach` (m). Collective.
void adaptDensity(Surface& surface, CellHalo& halo, const RowLists& lists, double reach, double finest);

}  // namespace thaw
