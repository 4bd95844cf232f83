// The volume of a shape, whatever it is made of.
#pragma once
#include <span>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"

namespace thaw {

/// m^3, of each shape: exact for boxes, balls, cylinders and rings, else by 96 points along each edge of the
/// bounding box, dealt out over the ranks (right to 0.3 %). The same on any number of ranks. 0 for what has
/// no end. Collective.
std::vector<double> shapeVolumes(std::span<const Shape* const> shapes, const MeshLoader& load, Reducer& all);

}  // namespace thaw
