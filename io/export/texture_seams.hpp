// SPDX-License-Identifier: Apache-2.0
// Texture coordinates of triangles at the seams of a texture.
#pragma once
#include <array>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "io/meshes/texture_coordinates.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

/// Returns the coordinates of each corner of each triangle. The corners of a triangle across a seam would
/// span the texture. The triangle takes the chart that two of its corners share; the third corner continues
/// that chart linearly. uv: per vertex.
std::vector<std::array<Uv, 3>> cornerUvs(const TriangleMesh& mesh, const std::vector<Uv>& uv);

/// Duplicates vertices at seams, so that each has one pair of texture coordinates. For formats without
/// coordinates of corners.
void splitAtSeams(ComponentMesh& mesh);

}  // namespace thaw
