// SPDX-License-Identifier: Apache-2.0
// Topology of the surface at the end of an update: overview.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Splits and merges components; deletes or moves surfels inside others (splitComponents, mergeComponents).
/// Surfels and particle copies may be on any rank, unsorted, without ghosts. Afterwards, they are sorted on
/// their owners, without ghosts, and components are measured. Call this before resampling: seams then close,
/// and drops without surfels get surfels, in the same update. The bits are the same on any number of ranks.
/// Collective.
void splitAndMerge(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

/// Measures Surface::components and Surfels::area, then enforces volumes if the scene requires it and the
/// surface is complete. start: the surface was just completed. Surfels may be on any rank, unsorted.
/// Afterwards, surfels and particle copies are sorted on their owners, without ghosts. Collective.
void measureSurface(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools, bool start = false);

/// Splits, merges and measures components.
void updateComponents(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

/// Labels connected parts, the first step of splitAndMerge. Without surfels, components consist of particles
/// only, and different bodies are not joined. Collective.
void labelParticles(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
