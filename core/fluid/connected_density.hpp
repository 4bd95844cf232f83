// How dense connected liquid is by the places of its particles.
#pragma once
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

/// Mean relative density (1) of the liquid particles that have at least two neighbours, summed over places; 1 where there are none, or where the
/// flow carries the density. The outermost layer of a flat surface has 0.87, a single layer 0.74. The same on any number of ranks. Collective.
double connectedDensity(const World& world, Reducer& all);

}  // namespace thaw
