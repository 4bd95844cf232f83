// SPDX-License-Identifier: Apache-2.0
// Triangle meshes from OBJ, PLY (ascii, binary of both byte orders) and STL (ascii, binary) files.
#pragma once
#include <functional>
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

/// Calls `parse` once with the content of a mesh file. Throws MeshError if the file cannot be read, or if
/// memory does not suffice.
void readMeshFile(const std::string& path, const std::function<void(std::string_view)>& parse);

enum class MeshFormat { Obj, Ply, AsciiStl, BinaryStl };

/// Returns the format of content without a byte order mark. Throws MeshError for other content.
MeshFormat meshFormatOf(std::string_view content, const std::string& file);

/// Returns the content after a byte order mark, if there is one.
std::string_view withoutByteOrderMark(std::string_view content);

/// Parses the content of a file; `file` is for messages.
TriangleMesh parseMesh(std::string_view content, const std::string& file);

TriangleMesh parseObj(std::string_view content, const std::string& file);
TriangleMesh parsePly(std::string_view content, const std::string& file);
TriangleMesh parseAsciiStl(std::string_view content, const std::string& file);
TriangleMesh parseBinaryStl(std::string_view content, const std::string& file);

}  // namespace thaw
