// SPDX-License-Identifier: Apache-2.0
// Texture coordinates of triangles at the seams of a texture.
#pragma once
#include <array>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "io/meshes/texture_coordinates.hpp"

namespace thaw {

/// Returns the coordinates of each corner of each triangle. A triangle across a seam has those of its first
/// corner at all three, since its corners would otherwise span the texture. uv: per vertex.
std::vector<std::array<Uv, 3>> cornerUvs(const TriangleMesh& mesh, const std::vector<Uv>& uv);

}  // namespace thaw
