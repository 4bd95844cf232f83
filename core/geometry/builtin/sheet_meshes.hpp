// SPDX-License-Identifier: Apache-2.0
// Analytic meshes of sheets for scenes without mesh files. Triangles are counter-clockwise seen from outside
// (or above).
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Returns a rectangle (m) in z = 0 around the origin. Squares of about `spacing` (m) along x and y are
/// divided into two triangles each.
TriangleMesh gridSheet(double width, double depth, double spacing);

/// Returns a sphere of this radius (m) around the origin: an icosahedron with edges divided into equal
/// parts of about `spacing` (m).
TriangleMesh sphereSheet(double radius, double spacing);

/// Returns a head of `height` (m) from chin to crown, facing -y, around the origin and closed below.
/// Vertices of a sphere are moved along rays from the centre.
TriangleMesh headSheet(double height, double spacing);

/// Returns the cap of a dome over a disc in z = 0, `height` (m) high, with radial ribs like a scallop.
TriangleMesh domeSheet(double radius, double height, double spacing, int ribs, double ribHeight);

/// Returns a skin on the +z side of a ball of this radius (m) around the origin. Its width (x) and height (y)
/// (m) are measured along the ball. It has `wrinkles` furrows along x, which rise `depth` (m) above the ball
/// and fade towards the border.
TriangleMesh foreheadSheet(double radius, double width, double height, double spacing, double depth,
                           int wrinkles);

}  // namespace thaw
