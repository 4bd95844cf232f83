// SPDX-License-Identifier: Apache-2.0
// PLY: x, y, z of the element 'vertex', and the list vertex_indices (or vertex_index) of 'face'. Also nx, ny,
// nz and red, green, blue if present; everything else is ignored.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/meshes/file_normals.hpp"
#include "io/meshes/ply_header.hpp"
#include "io/meshes/texture_coordinates.hpp"

namespace thaw {
namespace {

/// Sequential values of an ascii or binary file.
class PlyValues {
 public:
  PlyValues(std::string_view content, const std::string& file, const TextCursor& behindHeader,
            PlyFormat format)
      : text_(behindHeader),
        bytes_(content, file, behindHeader.offset()),
        format_(format),
        size_(content.size()) {}

  double number(ScalarType type) {
    if (format_ != PlyFormat::Ascii) return bytes_.number(type, format_ == PlyFormat::BigEndian);
    return text_.number(text_.word(), "a number");
  }
  /// Reads a finite number; what: "a coordinate", for the message.
  double finite(ScalarType type, const char* what) {
    return format_ != PlyFormat::Ascii ? bytes_.finite(type, format_ == PlyFormat::BigEndian, what)
                                       : text_.number(text_.word(), what);
  }
  /// Reads the length of a list, and checks that its values fit into the rest of the file.
  std::uint64_t length(const PlyProperty& p) {
    const double n = number(p.countType);
    if (n < 0 || n != std::floor(n)) fail(fmt::format("expected the length of a list, got {:g}", n));
    if (n * (format_ == PlyFormat::Ascii ? 2.0 : static_cast<double>(sizeOf(p.type))) >
        static_cast<double>(left()) + 1)
      fail("a list of " + std::to_string(static_cast<std::uint64_t>(n)) +
           " values does not fit into the rest of the file");
    return static_cast<std::uint64_t>(n);
  }
  void skip(const PlyProperty& p) {
    for (std::uint64_t n = p.list ? length(p) : 1; n > 0; n--) {
      if (format_ != PlyFormat::Ascii) bytes_.skip(sizeOf(p.type));
      else if (text_.word().empty())
        text_.fail("the file ends; expected a value of property '" + p.name + "'");
    }
  }
  std::size_t left() const {
    return format_ != PlyFormat::Ascii ? bytes_.left() : size_ - std::min(size_, text_.offset());
  }
  [[noreturn]] void fail(const std::string& message) const {
    if (format_ != PlyFormat::Ascii) bytes_.fail(message);
    text_.fail(message);
  }

 private:
  TextCursor text_;
  ByteCursor bytes_;
  PlyFormat format_;
  std::size_t size_;
};

struct PlyReader {
  PlyValues values;
  const TextCursor& header;
  PlyFormat format;
  TriangleMesh mesh;
  std::uint64_t vertices = 0;  // from the header; faces may come first
  std::vector<std::uint32_t> polygon;
  std::vector<Vec3d> normals;  // per vertex
  bool readsUv = false;
  std::vector<Uv> uvs{};  // per vertex

  /// Reserves memory for elements, after a check that they fit into the file.
  template<class T> void reserve(std::vector<T>& v, const PlyElement& e) const {
    std::size_t least = 0;
    for (const PlyProperty& p : e.properties)
      least += format == PlyFormat::Ascii ? 2 : p.list ? sizeOf(p.countType) : sizeOf(p.type);
    if (e.count > values.left() / std::max<std::size_t>(least, 1) + 1)
      header.failAt(e.line, "the header says " + std::to_string(e.count) + " of element '" + e.name +
                                "', which do not fit into the file");
    v.reserve(static_cast<std::size_t>(e.count));
  }

  /// Index (0, 1, 2) of each property among three names, else -1.
  struct Parts {
    std::vector<int> of;
    bool all = false;  ///< each name occurs exactly once
  };
  static Parts partsOf(const PlyElement& e, const std::array<const char*, 3>& names,
                       const std::string& prefix = "") {
    Parts p{std::vector<int>(e.properties.size(), -1)};
    int found[3] = {0, 0, 0};
    for (std::size_t k = 0; k < e.properties.size(); k++)
      for (int c = 0; c < 3; c++) {
        const std::string name = names[static_cast<std::size_t>(c)];
        if (!e.properties[k].list && (e.properties[k].name == name || e.properties[k].name == prefix + name))
          p.of[k] = c, found[c]++;
      }
    p.all = found[0] == 1 && found[1] == 1 && found[2] == 1;
    return p;
  }

  /// Sets the places of texture coordinates among the properties: 0 and 1, else -1. Returns whether both are
  /// there.
  static bool uvParts(const PlyElement& e, std::vector<int>& of) {
    for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
      of.assign(e.properties.size(), -1);
      int found = 0;
      for (std::size_t k = 0; k < e.properties.size(); k++)
        if (!e.properties[k].list && (e.properties[k].name == u || e.properties[k].name == v))
          of[k] = e.properties[k].name == u ? 0 : 1, found++;
      if (found == 2) return true;
    }
    return false;
  }

  /// Converts a colour to a byte: floating-point values from 0 to 1, 16-bit integers by their range.
  static std::uint32_t colourByte(double value, ScalarType type) {
    if (type == ScalarType::Float32 || type == ScalarType::Float64) value *= 255;
    else if (type == ScalarType::UInt16) value /= 257;
    return static_cast<std::uint32_t>(std::lround(std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 255.0)));
  }

  void readVertices(const PlyElement& e) {
    const Parts place = partsOf(e, {"x", "y", "z"}), normal = partsOf(e, {"nx", "ny", "nz"}),
                colour = partsOf(e, {"red", "green", "blue"}, "diffuse_");
    if (!place.all) header.failAt(e.line, "the element 'vertex' needs the properties x, y and z");
    std::vector<int> uvOf;
    const bool hasUv = readsUv && uvParts(e, uvOf);
    reserve(mesh.vertices, e);
    for (std::uint64_t i = 0; i < e.count; i++) {
      Vec3d v, n;
      std::uint32_t rgb = 0;
      Uv uv{};
      for (std::size_t k = 0; k < e.properties.size(); k++) {
        const PlyProperty& p = e.properties[k];
        if (place.of[k] >= 0) v[place.of[k]] = values.finite(p.type, "a coordinate");
        else if (normal.all && normal.of[k] >= 0)
          n[normal.of[k]] = values.finite(p.type, "a part of a normal");
        else if (colour.all && colour.of[k] >= 0)
          rgb |= colourByte(values.number(p.type), p.type) << 8 * colour.of[k];
        else if (hasUv && uvOf[k] >= 0)
          uv[static_cast<std::size_t>(uvOf[k])] = static_cast<float>(
              values.finite(p.type, "a texture coordinate"));
        else values.skip(p);
      }
      if (hasUv) uvs.push_back(uv);
      mesh.vertices.push_back(v);
      if (normal.all) normals.push_back(unitNormal(n));
      if (colour.all) mesh.colours.push_back(rgb);
    }
  }

  void readPolygon(const PlyProperty& p) {
    polygon.clear();
    for (std::uint64_t n = values.length(p); n > 0; n--) {
      const double index = values.number(p.type);
      if (!(index >= 0 && index < static_cast<double>(vertices)) || index != std::floor(index))
        values.fail(fmt::format("expected a vertex index below {}, the number of vertices, got {:g}",
                                vertices, index));
      polygon.push_back(static_cast<std::uint32_t>(index));
    }
    if (polygon.size() < 3)
      values.fail("a face with " + std::to_string(polygon.size()) + " corners; expected at least 3");
    for (std::size_t k = 2; k < polygon.size(); k++)
      mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }

  void readFaces(const PlyElement& e) {
    const auto indices = std::find_if(e.properties.begin(), e.properties.end(), [](const PlyProperty& p) {
      return p.list && (p.name == "vertex_indices" || p.name == "vertex_index");
    });
    if (indices == e.properties.end())
      header.failAt(e.line, "the element 'face' needs the property list vertex_indices");
    reserve(mesh.triangles, e);
    for (std::uint64_t n = 0; n < e.count; n++)
      for (auto p = e.properties.begin(); p != e.properties.end(); ++p) {
        if (p == indices) readPolygon(*p);
        else values.skip(*p);
      }
  }

  void assignNormals() {
    if (normals.empty()) return;
    mesh.normals.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
      mesh.normals.push_back({normals[t[0]], normals[t[1]], normals[t[2]]});
  }

  void skipElement(const PlyElement& e) {
    if (e.properties.empty()) return;
    for (std::uint64_t n = 0; n < e.count; n++)  // every iteration reads something, so it ends with the file
      for (const PlyProperty& p : e.properties) values.skip(p);
  }
};

}  // namespace

namespace {

/// readsUv: with texture coordinates.
TexturedMesh parseAll(std::string_view content, const std::string& file, bool readsUv) {
  TextCursor text(content, file);
  const PlyHeader header = readPlyHeader(text);
  PlyReader reader{
      PlyValues(content, file, text, header.format), text, header.format, {}, 0, {}, {}, readsUv};
  const auto named = [&](const char* name) {
    const auto e = std::find_if(header.elements.begin(), header.elements.end(),
                                [&](const PlyElement& x) { return x.name == name; });
    if (e == header.elements.end() || e->count == 0)
      text.fail("the file has no " + std::string(name) + " elements; expected a mesh of vertices and faces");
    return &*e;
  };
  const PlyElement *vertices = named("vertex"), *faces = named("face");
  if (vertices->count > 0xfffffff0u) text.failAt(vertices->line, "more vertices than 32 bits can count");
  reader.vertices = vertices->count;
  for (const PlyElement& e : header.elements) {
    if (&e == vertices) reader.readVertices(e);
    else if (&e == faces) reader.readFaces(e);
    else reader.skipElement(e);
  }
  reader.assignNormals();
  TexturedMesh textured{std::move(reader.mesh), {}};
  if (reader.uvs.empty()) return textured;
  for (const auto& t : textured.mesh.triangles)
    textured.uv.push_back({reader.uvs[t[0]], reader.uvs[t[1]], reader.uvs[t[2]]});
  return textured;
}

}  // namespace

TriangleMesh parsePly(std::string_view content, const std::string& file) {
  return parseAll(content, file, false).mesh;
}

TexturedMesh parseTexturedPly(std::string_view content, const std::string& file) {
  return parseAll(content, file, true);
}

}  // namespace thaw
