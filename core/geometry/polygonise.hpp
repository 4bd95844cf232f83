// Surface of an implicit function as triangles.
#pragma once
#include <functional>

#include "core/geometry/signed_distance.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// Surface value(x) = 0 within the bounds, by marching tetrahedra (Doi and Koide 1991; six tetrahedra a cube
/// around its diagonal, after Kuhn) on cubes of edge `spacing` (m): closed and outward, without equal
/// vertices. value < 0 inside; it has to be positive on the border of the bounds.
TriangleMesh polygonise(const std::function<double(const Vec3d&)>& value, const Bounds& bounds,
                        double spacing);

}  // namespace thaw
