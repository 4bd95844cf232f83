// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>
#include <string>

#include "io/export/colour_byte.hpp"
#include "io/export/export_surface.hpp"
#include "io/export/mesh_fields.hpp"
#include "io/export/out_file.hpp"

namespace thaw {

namespace {

/// Appended arrays: XML elements first, then the binary blocks in the same order, each after its length.
struct Appended {
  std::string xml;
  std::uint64_t offset = 0;
  std::vector<std::pair<std::uint64_t, std::function<void(OutFile&)>>> blocks;

  void add(const std::string& attributes, std::uint64_t bytes, std::function<void(OutFile&)> write) {
    xml += fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", attributes, offset);
    offset += sizeof(std::uint64_t) + bytes;
    blocks.emplace_back(bytes, std::move(write));
  }
  template<class T> void addVector(const std::string& attributes, const std::vector<T>& values) {
    add(attributes, values.size() * sizeof(T), [&values](OutFile& out) { out.array(values); });
  }
};

std::string escaped(const std::string& s) {
  std::string out;
  for (const char c : s)
    out += c == '"' ? "&quot;" : c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

std::vector<float> singlePoints(const std::vector<Vec3d>& positions) {
  std::vector<float> points;
  points.reserve(3 * positions.size());
  for (const Vec3d& x : positions)
    for (int a = 0; a < 3; a++) points.push_back(static_cast<float>(x[a]));
  return points;
}

const char* typeOf(Element e) {
  switch (e) {
    case Element::F64: return "Float64";
    case Element::F32: return "Float32";
    case Element::U64: return "UInt64";
    case Element::U32: return "UInt32";
    case Element::U16: return "UInt16";
    case Element::U8: return "UInt8";
    case Element::I64: return "Int64";
    case Element::I32: return "Int32";
    default: return nullptr;
  }
}

/// Adds a column with its type in the frame, so ids keep all bits.
void addColumn(Appended& a, const FrameColumn& c) {
  if (const char* type = typeOf(c.element))
    a.add(
        fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type, escaped(c.name), c.components),
        c.bytes.size(), [&c](OutFile& out) { out.bytes(c.bytes.data(), c.bytes.size()); });
}

struct CellCounts {
  std::uint64_t vertices = 0, lines = 0, polygons = 0;
};

/// Writes PolyData of points with these cells.
void writePolyData(const std::filesystem::path& file, double time, std::uint64_t points,
                   const CellCounts& cells, const Appended& a) {
  OutFile out(file);
  out.text(
      fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" "
                  "header_type=\"UInt64\">\n<PolyData>\n"
                  "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                  "format=\"ascii\">{:.17g}</DataArray>\n</FieldData>\n"
                  "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                  "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                  std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", time, points,
                  cells.vertices, cells.lines, cells.polygons));
  out.text(a.xml);
  out.text("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
  for (const auto& [bytes, write] : a.blocks) {
    out.number(bytes);
    write(out);
  }
  out.text("\n</AppendedData>\n</VTKFile>\n");
  out.finish();
}

}  // namespace

void writeVtp(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours) {
  const std::uint64_t n = frame.positions.size();
  const std::vector<float> points = singlePoints(frame.positions);
  std::vector<std::int64_t> connectivity(n), offsets(n);
  std::iota(connectivity.begin(), connectivity.end(), 0);
  std::iota(offsets.begin(), offsets.end(), 1);

  Appended a;
  a.xml = "<PointData Normals=\"normal\">\n";
  a.addVector("type=\"Float32\" Name=\"normal\" NumberOfComponents=\"3\"", frame.normals);
  a.addVector("type=\"Float32\" Name=\"radius\"", frame.radii);
  a.addVector("type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\"", colours);
  a.addVector("type=\"UInt64\" Name=\"id\"", frame.ids);
  a.addVector("type=\"UInt64\" Name=\"component\"", frame.components);
  for (const FrameColumn& c : frame.columns) addColumn(a, c);
  a.xml += "</PointData>\n<Points>\n";
  a.addVector("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", points);
  a.xml += "</Points>\n<Verts>\n";
  a.addVector("type=\"Int64\" Name=\"connectivity\"", connectivity);
  a.addVector("type=\"Int64\" Name=\"offsets\"", offsets);
  a.xml += "</Verts>\n";
  writePolyData(file, frame.time, n, {n, 0, 0}, a);
}

namespace {

/// Cells with the same number of points.
struct Cells {
  std::vector<std::int64_t> connectivity, offsets;
  template<class List> explicit Cells(const List& list) {
    for (const auto& c : list) {
      connectivity.insert(connectivity.end(), c.begin(), c.end());
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  }
  void addTo(Appended& a, const char* name) const {
    a.xml += fmt::format("<{}>\n", name);
    a.addVector("type=\"Int64\" Name=\"connectivity\"", connectivity);
    a.addVector("type=\"Int64\" Name=\"offsets\"", offsets);
    a.xml += fmt::format("</{}>\n", name);
  }
};

}  // namespace

void writeTrianglesVtp(const std::filesystem::path& file, const FrameData& frame,
                       const std::vector<std::array<std::uint32_t, 2>>& lines) {
  const std::uint64_t n = frame.positions.size();
  const std::vector<float> points = singlePoints(frame.positions);
  const Cells polygons(frame.triangles), edges(lines);
  Appended a;
  a.xml = "<PointData>\n";
  for (const FrameColumn& c : frame.columns) addColumn(a, c);
  a.xml += "</PointData>\n<Points>\n";
  a.addVector("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", points);
  a.xml += "</Points>\n";
  if (!lines.empty()) edges.addTo(a, "Lines");
  polygons.addTo(a, "Polys");
  writePolyData(file, frame.time, n, {0, lines.size(), frame.triangles.size()}, a);
}

namespace {

/// Point data of meshes in one file.
struct MeshColumns {
  std::vector<Vec3f> points, normals, velocities;
  std::vector<Rgb> colours;
  std::vector<float> temperatures, liquid;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::uint32_t> objects;
  std::vector<std::int64_t> labels;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> lines;

  explicit MeshColumns(const std::vector<ComponentMesh>& meshes) {
    const MeshFields fields(meshes);
    for (const ComponentMesh& m : meshes) {
      const auto first = static_cast<std::uint32_t>(points.size());
      for (const auto& t : m.mesh.triangles) triangles.push_back({first + t[0], first + t[1], first + t[2]});
      for (const auto& l : m.lines) lines.push_back({first + l[0], first + l[1]});
      for (std::size_t v = 0; v < m.mesh.vertices.size(); v++) {
        points.push_back(single(m.mesh.vertices[v]));
        normals.push_back(m.normals[v]);
        const Vec3f& c = m.colours[v];
        colours.push_back({colourByte(c.x), colourByte(c.y), colourByte(c.z)});
        if (fields.velocities) velocities.push_back(valueAt(m.velocities, v, noVector));
        if (fields.temperatures) temperatures.push_back(valueAt(m.temperatures, v, noNumber));
        if (fields.liquid) liquid.push_back(valueAt(m.liquid, v, noNumber));
        if (fields.uvs) uvs.push_back(valueAt(m.uvs, v, noUv));
      }
      objects.resize(points.size(), static_cast<std::uint32_t>(&m - meshes.data()));
      labels.resize(points.size(), labelOf(m));
    }
  }
  void addTo(Appended& a) const {
    a.addVector("type=\"Float32\" Name=\"normal\" NumberOfComponents=\"3\"", normals);
    a.addVector("type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\"", colours);
    a.addVector("type=\"UInt32\" Name=\"object\"", objects);
    a.addVector("type=\"Int64\" Name=\"component\"", labels);
    if (!velocities.empty())
      a.addVector("type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\"", velocities);
    if (!temperatures.empty()) a.addVector("type=\"Float32\" Name=\"temperature\"", temperatures);
    if (!liquid.empty()) a.addVector("type=\"Float32\" Name=\"liquid\"", liquid);
    if (!uvs.empty()) a.addVector("type=\"Float32\" Name=\"uv\" NumberOfComponents=\"2\"", uvs);
  }
};

}  // namespace

void writeMeshVtp(const std::filesystem::path& file, double time, const std::vector<ComponentMesh>& meshes) {
  const MeshColumns columns(meshes);
  const Cells polygons(columns.triangles), edges(columns.lines);
  Appended a;
  a.xml = "<PointData Normals=\"normal\">\n";
  columns.addTo(a);
  a.xml += "</PointData>\n<Points>\n";
  a.addVector("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", columns.points);
  a.xml += "</Points>\n";
  if (!columns.lines.empty()) edges.addTo(a, "Lines");
  polygons.addTo(a, "Polys");
  writePolyData(file, time, columns.points.size(), {0, columns.lines.size(), columns.triangles.size()}, a);
}

}  // namespace thaw
