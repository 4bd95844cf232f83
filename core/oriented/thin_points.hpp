// A few of many points, from which the surface can be rebuilt (3D interpolation).
#pragma once
#include "core/oriented/made_points.hpp"

namespace thaw {

/// Keeps a share of the points, held: most of them evenly, the others where the surface through those that
/// are kept already is farthest from the points (the greedy choice of centres of Carr et al. 2001, section
/// 4), a few at a time.
MadePoints thinned(const MadePoints& points, double share, std::uint64_t seed);

}  // namespace thaw
