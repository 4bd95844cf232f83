// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: vertices (with colours, if any), normals, texture coordinates and faces. Groups, materials,
// lines and points are ignored.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/meshes/file_normals.hpp"
#include "io/meshes/text_cursor.hpp"
#include "io/meshes/texture_coordinates.hpp"

namespace thaw {
namespace {

constexpr std::int64_t mostVertices = 0xfffffff0;

struct ObjReader {
  TextCursor text;
  TriangleMesh mesh{};
  /// Largest index of a list, 1-based, and its line: faces may precede the elements they reference.
  struct Largest {
    std::int64_t index = 0, line = 0;
  };
  Largest largest{}, largestNormal{}, largestUv{};
  std::vector<Vec3d> normals{};
  std::vector<std::uint32_t> polygon{}, polygonNormals{};  // current face; 0: no normal, else 1-based
  std::vector<std::array<std::uint32_t, 3>> normalsOf{};   // per triangle
  bool readsUv = false;
  std::vector<Uv> uvs{};
  std::vector<std::uint32_t> polygonUvs{};            // current face; 0: none, else 1-based
  std::vector<std::array<std::uint32_t, 3>> uvsOf{};  // per triangle; only with readsUv

  /// Returns the next word of the statement, which continues on the next line after a backslash.
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
    if (static_cast<std::int64_t>(mesh.vertices.size()) >= mostVertices)
      text.fail("more vertices than 32 bits can count");
    mesh.vertices.push_back(v);
    colour();
  }

  /// Reads the optional red, green, blue (0 to 1) after the coordinates; a single number is a weight.
  /// Vertices without colours are white.
  void colour() {
    double c[3];
    for (double& part : c) {
      const std::string_view w = word();
      if (w.empty() || w[0] == '#') return;
      part = text.number(w, "a colour or weight (v x y z r g b)");
    }
    mesh.colours.resize(mesh.vertices.size() - 1, 0xffffffu);
    std::uint32_t packed = 0;
    for (int k = 0; k < 3; k++)
      packed |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(c[k], 0.0, 1.0))) << 8 * k;
    mesh.colours.push_back(packed);
  }

  void normal() {
    Vec3d n;
    for (int a = 0; a < 3; a++) n[a] = text.number(word(), "a part of a normal (vn x y z)");
    if (static_cast<std::int64_t>(normals.size()) >= mostVertices)
      text.fail("more normals than 32 bits can count");
    normals.push_back(unitNormal(n));
  }

  void textureCoordinates() {
    Uv uv;
    for (float& part : uv) part = static_cast<float>(text.number(word(), "a texture coordinate (vt u v)"));
    uvs.push_back(uv);
  }

  /// Returns an index into a list of `had` elements so far, 1-based; kind: "vertex", "normal" or "texture".
  std::uint32_t index(std::string_view w, const std::string& kind, std::size_t had, Largest& most) const {
    const std::string what = "a " + kind + " index (v, v/vt, v/vt/vn or v//vn)";
    std::int64_t n = text.integer(w, what.c_str());
    const auto count = static_cast<std::int64_t>(had);
    if (n == 0) text.fail(kind + " index 0; they begin with 1, or with -1 for the last one");
    if (n < 0) {
      if (n < -count)
        text.fail(kind + " index " + std::to_string(n) + ", but only " + std::to_string(count) +
                  (kind == "vertex"   ? " vertices"
                   : kind == "normal" ? " normals"
                                      : " texture coordinates") +
                  " came before");
      n += count + 1;
    }
    if (n > most.index) most = {n, text.line()};
    if (n > mostVertices) text.fail(kind + " index " + std::to_string(n) + " exceeds 32 bits");
    return static_cast<std::uint32_t>(n);
  }

  void corner(std::string_view w) {
    const std::size_t slash = w.find('/'),
                      second = slash == std::string_view::npos ? slash : w.find('/', slash + 1);
    polygon.push_back(index(w.substr(0, slash), "vertex", mesh.vertices.size(), largest) - 1);
    const std::string_view last = second == std::string_view::npos ? std::string_view()
                                                                   : w.substr(second + 1);
    if (readsUv) {
      const std::string_view middle = slash == std::string_view::npos
                                          ? std::string_view()
                                          : w.substr(slash + 1, second == std::string_view::npos
                                                                    ? second
                                                                    : second - slash - 1);
      polygonUvs.push_back(middle.empty() ? 0 : index(middle, "texture", uvs.size(), largestUv));
    }
    polygonNormals.push_back(last.empty() ? 0 : index(last, "normal", normals.size(), largestNormal));
  }

  void face() {
    polygon.clear();
    polygonNormals.clear();
    polygonUvs.clear();
    for (std::string_view w = word(); !w.empty() && w[0] != '#'; w = word()) corner(w);
    if (polygon.size() < 3)
      text.fail("a face with " + std::to_string(polygon.size()) + " corners; expected at least 3");
    for (std::size_t k = 2; k < polygon.size(); k++) {
      mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
      normalsOf.push_back({polygonNormals[0], polygonNormals[k - 1], polygonNormals[k]});
      if (readsUv) uvsOf.push_back({polygonUvs[0], polygonUvs[k - 1], polygonUvs[k]});
    }
  }

  void expectAll(const Largest& most, std::size_t count, const char* kind, const char* plural) const {
    if (most.index > static_cast<std::int64_t>(count))
      text.failAt(most.line, std::string(kind) + " index " + std::to_string(most.index) +
                                 ", but the file has " + std::to_string(count) + " " + plural);
  }

  void assignNormals() {
    if (largestNormal.index == 0) return;
    mesh.normals.resize(normalsOf.size());
    for (std::size_t t = 0; t < normalsOf.size(); t++)
      for (std::size_t k = 0; k < 3; k++)
        if (normalsOf[t][k] > 0) mesh.normals[t][k] = normals[normalsOf[t][k] - 1];
  }

  void read() {
    while (!text.atEnd()) {
      const std::string_view keyword = text.wordOnLine();
      if (keyword == "v") vertex();
      else if (keyword == "vn") normal();
      else if (keyword == "vt" && readsUv) textureCoordinates();
      else if (keyword == "f") face();
      text.restOfLine();
    }
    if (mesh.vertices.empty())
      text.failAt(1, "no vertices found; expected an OBJ (lines 'v x y z' and 'f a b c'), PLY or STL mesh");
    if (mesh.triangles.empty()) text.failAt(text.line(), "no faces found; expected lines 'f a b c'");
    if (!mesh.colours.empty()) mesh.colours.resize(mesh.vertices.size(), 0xffffffu);
    expectAll(largest, mesh.vertices.size(), "vertex", "vertices");
    expectAll(largestNormal, normals.size(), "normal", "normals");
    expectAll(largestUv, uvs.size(), "texture", "texture coordinates");
    assignNormals();
  }
};

}  // namespace

TriangleMesh parseObj(std::string_view content, const std::string& file) {
  ObjReader reader{.text = TextCursor(content, file)};
  reader.read();
  return std::move(reader.mesh);
}

TexturedMesh parseTexturedObj(std::string_view content, const std::string& file) {
  ObjReader reader{.text = TextCursor(content, file), .readsUv = true};
  reader.read();
  TexturedMesh textured{std::move(reader.mesh), {}};
  if (reader.uvs.empty()) return textured;
  for (const auto& t : reader.uvsOf) {
    std::array<Uv, 3> corners{};
    for (std::size_t k = 0; k < 3; k++)
      if (t[k] > 0) corners[k] = reader.uvs[t[k] - 1];
    textured.uv.push_back(corners);
  }
  return textured;
}

}  // namespace thaw
