// SPDX-License-Identifier: Apache-2.0
// Volumes of shapes.
#pragma once
#include <span>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"

namespace thaw {

/// Returns the volume of each shape (m^3), exact for boxes, spheres, cylinders and tori. For other shapes, it
/// counts points inside, 96 along each edge of the bounding box, distributed over the ranks (accurate to 0.3
/// %). Infinite shapes give 0. The result is the same on any number of ranks. Collective.
std::vector<double> shapeVolumes(std::span<const Shape* const> shapes, const MeshLoader& load, Reducer& all);

}  // namespace thaw
