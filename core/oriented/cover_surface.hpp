// Particles all over the surface of a shape.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/oriented/made_points.hpp"

namespace thaw {

/// Points on a surface, about a spacing apart: projected samples of a fine lattice in an order that is a hash, then moved apart along it. Only the parts of the lattice
/// that may be near the surface are looked at. Throws std::invalid_argument: the surface has no end, or is too long for its spacing.
MadePoints coverSurface(const SignedDistance& shape, double spacing, std::uint64_t seed);

}  // namespace thaw
