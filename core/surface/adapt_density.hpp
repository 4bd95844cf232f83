// Density of surfels that follows the curvature of the surface, so that small drops and edges are kept (K05's
// future work).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/row_lists.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Angle (rad) between the normals of neighbours that the wanted spacing makes of a curved surface.
inline constexpr double angleBetween = 0.5;
/// Largest growth of the wanted spacing with the distance from where it is smaller: neighbours differ by 1.3
/// times at most.
inline constexpr double grading = 0.25;

/// Surfels::radius of owned surfels and ghosts: where the surface curves, angleBetween over the largest
/// curvature, the mean of the neighbours'; between finest (m) and the spacing of the surface; graded. What is
/// within a tenth of that stays as it is, else it goes half of the way, so that the density does not flicker.
/// finest = spacing: the radius goes back to the spacing everywhere. Needs ghosts with position, normal,
/// component and radius, and lists within `reach` (m). Collective.
void adaptDensity(Surface& surface, CellHalo& halo, const RowLists& lists, double reach, double finest);

}  // namespace thaw
