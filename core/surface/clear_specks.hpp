// Surfels that have come alone among those of another colour.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Where liquids of two colours run into each other surfels of one are carried in among those of the other,
/// one by one. A liquid surfel whose colour nearly none of those around it on its side of the component have
/// gets their mean. Borders between colours, and spots of more than a few surfels, stay as they are; what is
/// solid keeps each mark. Scenes of one colour pay nothing. Places the surfels. Collective.
void clearSpecks(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
