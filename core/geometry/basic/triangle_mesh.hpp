// SPDX-License-Identifier: Apache-2.0
// Triangles from a file or from code, without guarantees. mesh_repair.hpp turns them into a solid.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct TriangleMesh {
  std::vector<Vec3d> vertices;                          // m
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices, counter-clockwise seen from
                                                        // outside
  std::vector<std::uint32_t> colours{};  // by vertex, red | green << 8 | blue << 16; empty if the file has
                                         // none
  std::vector<std::array<Vec3d, 3>> normals{};  // unit normals of triangle corners, 0 where the file has
                                                // none; empty without normals
};

/// Returns the area of all triangles (m^2).
inline double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * length(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                               mesh.vertices[t[2]] - mesh.vertices[t[0]]));
  return area;
}

/// Reads the mesh at a path. Throws a std::exception whose what() gives file, position and expected content.
/// io/meshes implements the loader for files, so core does not read files.
using MeshLoader = std::function<TriangleMesh(const std::string& path)>;

}  // namespace thaw
