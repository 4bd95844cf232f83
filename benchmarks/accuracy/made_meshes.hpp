// SPDX-License-Identifier: Apache-2.0
// Meshes that the suite generates in place of reading files.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw::accuracy {

/// Loads "made_ball.obj" (radius 1), "made_cube.obj" (edge 2) and "made_bumps.obj"; other names are files.
/// "made_bumps.obj" is a ball of radius 1 with bumps 4 % high and cubic symmetry, so that all axes through
/// its centre are principal.
MeshLoader suiteMeshes();

}  // namespace thaw::accuracy
