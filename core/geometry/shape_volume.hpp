// The volume of a shape, whatever it is made of.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"

namespace thaw {

/// m^3, by 96 points along each edge of the bounding box (a box is exact, a ball right to .1 %, a thin ring to .3 %), dealt out over the ranks; the same on any number of them. 0 for
/// what has no end. Collective.
double shapeVolume(const SignedDistance& shape, Reducer& all);

}  // namespace thaw
