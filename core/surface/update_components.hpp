// The topology of the surface at the end of an update: the page to read.
#pragma once
#include "core/surface/components.hpp"
#include "core/surface/merge.hpp"
#include "core/surface/surfel_area.hpp"

namespace thaw {

struct SurfaceTools;

/// What updateComponents works with; kept for its memory.
struct TopologyTools {
  ComponentTools components;
  MergeTools merge;
  AreaLists areas;
};

/// Components come apart and join; surfels of the wrong place are deleted or moved (splitComponents,
/// mergeComponents). Surfels and particle copies may be on any rank, unsorted, without ghosts; afterwards
/// both are placed, without ghosts, and the components measured. To be called before surfels are resampled,
/// so that seams of merges close and drops without surfels get theirs in the same update. Collective; the
/// same bits on any number of ranks.
void splitAndMerge(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Surface::components of what there is, and Surfels::area; then volume keeping, where the scene wants it and
/// the surface is not just being made; start: it has been, just now. Surfels may be on any rank, unsorted;
/// afterwards both tables are placed, without ghosts. Collective.
void measureSurface(World& world, SurfaceHalos halos, SurfaceTools& tools, bool start = false);

/// Both.
void updateComponents(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// The first part of splitAndMerge: what hangs together gets its labels. Before there are surfels: components
/// of particles alone, where those of different bodies are not one. Collective.
void labelParticles(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
