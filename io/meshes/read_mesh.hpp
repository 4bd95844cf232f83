// Triangle meshes from OBJ, PLY (ascii, binary of both byte orders) and STL (ascii, binary) files.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// What is wrong with a mesh file: "FILE:LINE: ..." or "FILE: byte N: ..." and what was expected there.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a mesh; what kind of file it is, its content tells. Polygons become fans of triangles; lengths are
/// taken as m. Coordinates are finite and indices valid afterwards, and there is at least one triangle;
/// whether the mesh is closed is not looked at (core/geometry/mesh_repair.hpp). Does not depend on the
/// locale. Allocates no more than a small multiple of the file's size. Throws MeshError.
TriangleMesh readMesh(const std::string& path);

/// The same from the content of a file; `file` is for messages.
TriangleMesh parseMesh(std::string_view content, const std::string& file);

TriangleMesh parseObj(std::string_view content, const std::string& file);
TriangleMesh parsePly(std::string_view content, const std::string& file);
TriangleMesh parseAsciiStl(std::string_view content, const std::string& file);
TriangleMesh parseBinaryStl(std::string_view content, const std::string& file);

}  // namespace thaw
