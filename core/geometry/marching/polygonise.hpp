// SPDX-License-Identifier: Apache-2.0
// Triangulation of an implicit function's zero set.
#pragma once
#include <functional>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Returns the surface value(x) = 0 within the bounds (m): closed, with outward triangles, without duplicate
/// vertices. It uses marching cubes (LC87) with edges of `spacing` (m). value < 0 inside. Requires: value > 0
/// on the border of the bounds.
TriangleMesh polygonise(const std::function<double(const Vec3d&)>& value, const Bounds& bounds,
                        double spacing);

}  // namespace thaw
