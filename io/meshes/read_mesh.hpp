// SPDX-License-Identifier: Apache-2.0
// Triangle meshes from OBJ, PLY (ascii, binary of both byte orders) and STL (ascii, binary) files.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Error of a mesh file: "FILE:LINE: ..." or "FILE: byte N: ..." with what was expected there.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a mesh; the content determines the format. Polygons become triangle fans; lengths are in m. Ensures:
/// finite coordinates, valid indices, at least one triangle. The mesh may be open
/// (core/geometry/meshes/mesh_repair.hpp). Independent of the locale. Memory is a small multiple of the
/// file's size. Throws MeshError.
TriangleMesh readMesh(const std::string& path);

/// Parses the content of a file; `file` is for messages.
TriangleMesh parseMesh(std::string_view content, const std::string& file);

TriangleMesh parseObj(std::string_view content, const std::string& file);
TriangleMesh parsePly(std::string_view content, const std::string& file);
TriangleMesh parseAsciiStl(std::string_view content, const std::string& file);
TriangleMesh parseBinaryStl(std::string_view content, const std::string& file);

}  // namespace thaw
