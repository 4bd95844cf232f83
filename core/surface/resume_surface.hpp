// SPDX-License-Identifier: Apache-2.0
// Prepares a surface from a checkpoint or a snapshot, and partitions surfaces over ranks.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Sorts surfels, which may have any order, and partitions the domain by surfel counts. The next update
/// migrates the surfels. Collective.
void resumeSurface(Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Repartitions the domain if the halo requires it. Surfel counts are used as weights, since updates are
/// too rare to time. Requires: no update in progress. force: always partition. Collective.
void balanceSurface(Surface& surface, SurfaceHalos halos, SurfaceTools& tools, bool force);

/// Makes the first partition, before surfels exist, by gathered particle copies that are not placed yet.
/// Collective.
void partitionByParticles(Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Clears surfels, components, events and other state. Radii and grid remain.
void emptySurface(Surface& surface);

}  // namespace thaw
