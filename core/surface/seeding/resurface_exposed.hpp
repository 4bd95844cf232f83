// SPDX-License-Identifier: Apache-2.0
// Grows surfels on exposed particles, for example on crack faces (K05 4.3).
#pragma once
#include <cstdint>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Distance in particle spacings from grown surfels within which mesh surfels are tested for detachment.
inline constexpr double detachedReach = 3.5;

/// Grows surfels around exposed particles. A particle is exposed in a direction without particles and
/// surfels of its component. Crack faces are exposed when the colour field has dropped in the gap, separated
/// parts at once. Existing surfels keep position and detail. New surfels keep a distance from existing ones,
/// and resampling closes the seam. Detached surfels of solids, for example at the edge of a crack, are
/// deleted. If surfels are born, Surfels::relaxesOnce becomes active. New surfels, including those added by
/// resampling, then relax in this update although they are solid. Returns the number of births on all ranks.
/// Requires: placed surfels and particles; components of this update. Afterwards, surfels have no valid
/// cells. Collective.
std::int64_t resurfaceExposed(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
