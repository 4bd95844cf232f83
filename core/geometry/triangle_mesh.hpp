// Triangles as a file has them or as code makes them; nothing is promised about them (mesh_repair.hpp makes a
// solid of them).
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
  std::vector<std::uint32_t> colours{};  // of vertices, red | green << 8 | blue << 16; empty where the file
                                         // has none
  std::vector<std::array<Vec3d, 3>> normals{};  // of the corners of triangles, unit ones, or 0 where the file
                                                // says nothing; empty where it has none
};

/// m^2, of all triangles.
inline double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * length(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                               mesh.vertices[t[2]] - mesh.vertices[t[0]]));
  return area;
}

/// Reads the mesh of a path; throws a std::exception whose what() names file, place and what was expected
/// there. io/meshes has the one for files, so that core reads none.
using MeshLoader = std::function<TriangleMesh(const std::string& path)>;

}  // namespace thaw
