// SPDX-License-Identifier: Apache-2.0
// STL, ascii and binary. Every triangle has its own corners; equal ones are merged.
#include <cmath>
#include <cstring>

#include "core/geometry/meshes/weld_vertices.hpp"
#include "io/meshes/byte_cursor.hpp"
#include "io/meshes/text_cursor.hpp"

namespace thaw {
namespace {

void addCorner(TriangleMesh& mesh, const Vec3d& x) {
  mesh.vertices.push_back(x);
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  if (n % 3 == 0) mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

TriangleMesh welded(const TriangleMesh& mesh, const std::string& file) {
  TriangleMesh w = weldVertices(mesh, 0);
  if (w.triangles.empty())
    throw MeshError(file + ": every triangle has two equal corners; expected the surface of a solid");
  return w;
}

}  // namespace

TriangleMesh parseAsciiStl(std::string_view content, const std::string& file) {
  TextCursor text(content, file);
  TriangleMesh mesh;
  const auto expect = [&](const char* wanted) {
    const std::string_view w = text.word();
    if (w != wanted) text.fail("expected '" + std::string(wanted) + "', got " + TextCursor::shown(w));
  };
  for (std::string_view w = text.word(); !w.empty(); w = text.word()) {
    if (w != "solid") text.fail("expected 'solid', got " + TextCursor::shown(w));
    text.restOfLine();  // name of the solid
    for (w = text.word(); w != "endsolid"; w = text.word()) {
      if (w != "facet") text.fail("expected 'facet' or 'endsolid', got " + TextCursor::shown(w));
      expect("normal");
      for (int a = 0; a < 3; a++)
        // the normal is ignored; it is often wrong
        if (text.word().empty()) text.fail("expected a normal, got the end");
      expect("outer");
      expect("loop");
      for (int corner = 0; corner < 3; corner++) {
        expect("vertex");
        Vec3d x;
        for (int a = 0; a < 3; a++) x[a] = text.number(text.word(), "a coordinate (vertex x y z)");
        addCorner(mesh, x);
      }
      expect("endloop");
      expect("endfacet");
    }
    text.restOfLine();
  }
  if (mesh.triangles.empty()) text.fail("no facets found; expected the surface of a solid");
  return welded(mesh, file);
}

TriangleMesh parseBinaryStl(std::string_view content, const std::string& file) {
  if (content.size() < 84)
    throw MeshError(file + ": byte " + std::to_string(content.size()) +
                    ": the file ends; expected the 84 bytes that a binary STL file begins with");
  ByteCursor bytes(content, file, 80);
  const auto count = static_cast<std::uint32_t>(bytes.number(ScalarType::UInt32, false));
  if (content.size() - 84 != std::uint64_t{count} * 50)
    throw MeshError(file + ": byte 80: the header of the binary STL file says " + std::to_string(count) +
                    " triangles, which make " + std::to_string(84 + std::uint64_t{count} * 50) +
                    " bytes; the file has " + std::to_string(content.size()));
  if (count > 0x50000000u)
    throw MeshError(file + ": byte 80: more triangles than 32 bits can count the corners of");
  if (count == 0) throw MeshError(file + ": byte 80: no triangles; expected the surface of a solid");
  TriangleMesh mesh;
  mesh.vertices.reserve(std::size_t{count} * 3);
  mesh.triangles.reserve(count);
  for (std::uint32_t t = 0; t < count; t++) {
    bytes.skip(12);  // normal
    for (int corner = 0; corner < 3; corner++) {
      Vec3d x;
      for (int a = 0; a < 3; a++) x[a] = bytes.finite(ScalarType::Float32, false);
      addCorner(mesh, x);
    }
    bytes.skip(2);
  }
  return welded(mesh, file);
}

}  // namespace thaw
