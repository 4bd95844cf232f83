// Components that meet: they join, or their surfaces are kept apart (K05 4.4.2).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/components.hpp"
#include "core/surface/inside.hpp"
#include "core/world.hpp"

namespace thaw {

struct MergeTools {
  InsideTools inside;
  std::vector<SurfaceSide> sides, touching;
  std::vector<Vec3d> moved;
  std::vector<std::uint8_t> open;   ///< surfels that resampling is to look at
  std::vector<std::uint64_t> into;  ///< labels of surfels, ghosts included, when all have joined
};

/// Joins components of which at least one has a particle inside the other's surface, or, of liquids, which
/// are as near to each other as particles of one liquid are, as the scene's rule allows: Liquid where the
/// particle or the surface there is more than half liquid, All, None. All that happens in one update is found
/// together, as a union over labels; the smallest label stays. Surfels inside the other's surface, or less
/// than half a spacing off it, are deleted on both sides, so that the seam closes as they are resampled.
/// Where components do not join, surfels inside the other's surface go back to the middle between the two.
/// Needs placed surfels and particles with ghosts; afterwards surfels have no ghosts and may have left their
/// cells. Collective.
void mergeComponents(World& world, SurfaceHalos halos, ComponentTools& components, MergeTools& tools);

}  // namespace thaw
