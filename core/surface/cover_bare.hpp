// Surfels where the particles' surface has none: on the faces of cracks, on what came into the open
// (K05 4.3).
#pragma once
#include <cstdint>

#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Surfels of a mesh that hang off are looked for where grown ones are within this many spacings of the
/// particles.
inline constexpr double ragReach = 3.5;

/// Grows surfels around particles that look out of their component in a direction in which neither particles
/// nor surfels are: the faces of a crack, once it is so wide that the colour field falls between them; on a
/// part that came off, at once. Surfels that are there stay as they are, with what detail they carry, and new
/// ones keep away from them: resampling closes the seam between the two. Old ones of a solid that hang off
/// the surface, as at the rim of a crack, are deleted. Where any was born, Surfels::loose is active and says
/// that new ones, and those that resampling adds, settle in this update though they are solid. Returns how
/// many were born, on all ranks. Needs placed surfels and particles and the components of this update;
/// surfels have no valid cells afterwards. Collective.
std::int64_t coverBare(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
