// The topology of the surface at the end of an update: the page to read.
#pragma once
#include "core/surface/components.hpp"
#include "core/surface/merge.hpp"

namespace thaw {

struct SurfaceTools;

/// What updateComponents works with; kept for its memory.
struct TopologyTools {
  ComponentTools components;
  MergeTools merge;
};

/// Splits and merges components, measures them and keeps their volume. Surfels and particle copies may be on any rank, unsorted, without
/// ghosts; afterwards they are placed (ghosts dropped), but for what volume keeping moved them. Collective; the same bits on any number of ranks.
void updateComponents(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Components of particles alone, before there are surfels: labels in SurfaceParticles::component. Particles of different bodies are not one.
/// Particle copies may be on any rank; afterwards they are placed, without ghosts. Collective.
void labelParticles(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
