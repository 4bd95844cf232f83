// Meshes of sheets that the scenes need, made by formulas: no file. Triangles are counter-clockwise seen from
// outside (or above).
#pragma once
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// Rectangle in the plane z = 0 around the origin, of threads along x and y about `spacing` (m) apart;
/// squares, each cut into two triangles.
TriangleMesh gridSheet(double width, double depth, double spacing);

/// Sphere around the origin: an icosahedron whose edges are cut into equal parts of about `spacing` (m).
TriangleMesh sphereSheet(double radius, double spacing);

/// A head, `height` (m) from chin to crown, looking along -y, around the origin; closed below. Vertices of a
/// sphere on rays from the middle.
TriangleMesh headSheet(double height, double spacing);

/// Cap of a sphere-like dome over a disc in z = 0, `height` high, with radial ribs as a scallop has them.
TriangleMesh domeSheet(double radius, double height, double spacing, int ribs, double ribHeight);

/// Skin over a ball of this radius (m) around the origin, on its side towards +z, width (x) by height (y)
/// measured along the ball, with so many furrows across, which rise `depth` above the ball and fade towards
/// the border.
TriangleMesh foreheadSheet(double radius, double width, double height, double spacing, double depth,
                           int wrinkles);

}  // namespace thaw
