// Wavefront OBJ: vertices (with colours where they have any) and faces; texture coordinates, normals, groups, materials, lines and points are passed over.
#include <algorithm>
#include <cmath>
#include <vector>

#include "io/meshes/text_cursor.hpp"

namespace thaw {
namespace {

constexpr std::int64_t mostVertices = 0xfffffff0;

struct ObjReader {
  TextCursor text;
  TriangleMesh mesh;
  std::int64_t largest = 0, largestLine = 0;  // index, 1-based: faces may come before their vertices
  std::vector<std::uint32_t> polygon;

  /// Next word of the statement, which goes on in the next line after a backslash.
  std::string_view word() {
    std::string_view w = text.wordOnLine();
    while (w == "\\") {
      text.restOfLine();
      w = text.wordOnLine();
    }
    return w;
  }

  void vertex() {
    Vec3d v;
    for (int a = 0; a < 3; a++) v[a] = text.number(word(), "a coordinate (v x y z)");
    if (static_cast<std::int64_t>(mesh.vertices.size()) >= mostVertices) text.fail("more vertices than 32 bits can count");
    mesh.vertices.push_back(v);
    colour();
  }

  /// Behind the coordinates many programs write red, green, blue from 0 to 1; a single number there is a weight. Vertices without are white.
  void colour() {
    double c[3];
    for (double& part : c) {
      const std::string_view w = word();
      if (w.empty() || w[0] == '#') return;
      part = text.number(w, "a colour or weight (v x y z r g b)");
    }
    mesh.colours.resize(mesh.vertices.size() - 1, 0xffffffu);
    std::uint32_t packed = 0;
    for (int k = 0; k < 3; k++) packed |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(c[k], 0.0, 1.0))) << 8 * k;
    mesh.colours.push_back(packed);
  }

  void corner(std::string_view w) {
    const std::string_view index = w.substr(0, w.find('/'));
    std::int64_t n = text.integer(index, "a vertex index (v, v/vt, v/vt/vn or v//vn)");
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    if (n == 0) text.fail("vertex index 0; they begin with 1, or with -1 for the last one");
    if (n < 0) {
      if (n < -count) text.fail("vertex index " + std::to_string(n) + ", but only " + std::to_string(count) + " vertices came before");
      n += count + 1;
    }
    if (n > largest) largest = n, largestLine = text.line();
    if (n > mostVertices) text.fail("vertex index " + std::to_string(n) + " is larger than 32 bits can count");
    polygon.push_back(static_cast<std::uint32_t>(n - 1));
  }

  void face() {
    polygon.clear();
    for (std::string_view w = word(); !w.empty() && w[0] != '#'; w = word()) corner(w);
    if (polygon.size() < 3) text.fail("a face with " + std::to_string(polygon.size()) + " corners; expected at least 3");
    for (std::size_t k = 2; k < polygon.size(); k++) mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }

  void read() {
    while (!text.atEnd()) {
      const std::string_view keyword = text.wordOnLine();
      if (keyword == "v") vertex();
      else if (keyword == "f") face();
      text.restOfLine();
    }
    if (mesh.vertices.empty()) text.failAt(1, "no vertices found; expected an OBJ (lines 'v x y z' and 'f a b c'), PLY or STL mesh");
    if (mesh.triangles.empty()) text.failAt(text.line(), "no faces found; expected lines 'f a b c'");
    if (!mesh.colours.empty()) mesh.colours.resize(mesh.vertices.size(), 0xffffffu);
    if (largest > static_cast<std::int64_t>(mesh.vertices.size()))
      text.failAt(largestLine, "vertex index " + std::to_string(largest) + ", but the file has " + std::to_string(mesh.vertices.size()) + " vertices");
  }
};

}  // namespace

TriangleMesh parseObj(std::string_view content, const std::string& file) {
  ObjReader reader{TextCursor(content, file), {}, 0, 0, {}};
  reader.read();
  return std::move(reader.mesh);
}

}  // namespace thaw
