// SPDX-License-Identifier: Apache-2.0
// Prepares a surface from a checkpoint or a snapshot, and partitions surfaces over ranks.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Sorts surfels of any order and partitions the domain by them. The next update migrates them. Collective.
void resumeSurface(Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Repartitions the domain if the halo requires it. Surfel counts are used as weights, since updates are
/// too rare to time. Requires: no update in progress. force: always partition. Collective.
void balanceSurface(Surface& surface, SurfaceHalos halos, SurfaceTools& tools, bool force);

/// Makes the first partition, before there are surfels, by gathered, unplaced particle copies. Collective.
void partitionByParticles(Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Clears surfels, components, events and other state. Radii and grid remain.
void emptySurface(Surface& surface);

}  // namespace thaw
