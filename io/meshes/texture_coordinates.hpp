// SPDX-License-Identifier: Apache-2.0
// Texture coordinates of mesh files.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"

namespace thaw {

using Uv = std::array<float, 2>;

/// A mesh as stored in its file, with texture coordinates of the corners of each triangle.
struct TexturedMesh {
  TriangleMesh mesh;
  std::vector<std::array<Uv, 3>> uv;  ///< per triangle; empty if the file has none
};

/// Reads a mesh with texture coordinates. These are `vt` of OBJ, or the vertex properties s and t, u and v,
/// or texture_u and texture_v of PLY. Other files have none. Throws MeshError.
TexturedMesh readTexturedMesh(const std::string& path);

TexturedMesh parseTexturedObj(std::string_view content, const std::string& file);
TexturedMesh parseTexturedPly(std::string_view content, const std::string& file);

/// Texture coordinates on the surface of a mesh.
class TextureLookup {
 public:
  /// Requires: a mesh with texture coordinates.
  explicit TextureLookup(TexturedMesh mesh);
  /// Returns the coordinates at the point of the surface that is closest to x (m, in the file's frame).
  Uv at(const Vec3d& x) const;

 private:
  TexturedMesh textured_;
  TriangleBvh tree_;
};

}  // namespace thaw
