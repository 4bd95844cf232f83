// Meshes that cases of the suite make instead of reading them from files.
#pragma once
#include "core/geometry/triangle_mesh.hpp"

namespace thaw::accuracy {

/// Loads "made_ball.obj" (radius 1), "made_cube.obj" (edge 2) and "made_bumps.obj" (a ball of radius 1 with
/// bumps 4 % high, as symmetric as a cube, so that all axes through its middle are principal); all else as
/// files.
MeshLoader suiteMeshes();

}  // namespace thaw::accuracy
